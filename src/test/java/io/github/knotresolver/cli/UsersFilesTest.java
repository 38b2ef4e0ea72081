package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.imagej.TestImages;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;

/** No subcommand replaces what it reads, or anything unasked. */
class UsersFilesTest {

	@TempDir
	Path home;
	private Path sim;
	private Path result;
	private final StringWriter err = new StringWriter();

	@BeforeEach
	void makeAMovieAndItsResult() {
		sim = home.resolve("sim");
		result = home.resolve("result");
		assertEquals(0, run("simulate", "--out", sim, "--length", "4", "--frames", "4",
			"--duration", "4", "--time-step", "0.02", "--seed", "1"), err.toString());
		TestImages.save(TestImages.movie(5, 8), home.resolve("movie.tif"));
		assertEquals(0, run("resolve", home.resolve("movie.tif"), "--out", result, "--no-plots"));
	}

	@Test
	void whatIsReadIsNeverReplaced() throws IOException {
		refused("sim holds", "resolve", sim.resolve("movie.tif"), "--out", sim, "--force");
		refused("which is read", "resolve", result.resolve("overlay.tif"), "--out", result,
			"--force");
		refused("contours.csv, which is read", "resolve", home.resolve("movie.tif"), "--out",
			result, "--force", "--corrections", result.resolve("contours.csv"));
		refused("is the folder that is read", "measure", result, "--out", result, "--force");
		refused("contours.csv, which is read", "measure", result.resolve("contours.csv"), "--out",
			result, "--force");
		refused("is the folder that is read", "evaluate", "--like", result, "--out", result,
			"--force");
		refused("is a file that is read", "evaluate", "--truth", sim.resolve("contours.csv"),
			"--result", result, "--out", sim.resolve("contours.csv"), "--force");
		refused("is a file that is read", "evaluate", "--truth", sim, "--result", result, "--out",
			result.resolve("contours.csv"), "--force");
	}

	@Test
	void nothingIsReplacedUnasked() throws IOException {
		final Path scores = home.resolve("scores.csv");
		refused("not written by this program", "evaluate", "--truth", sim, "--result", result,
			"--out", home.resolve("movie.tif"), "--force");
		assertEquals(0,
			run("evaluate", "--truth", sim, "--result", result, "--out", scores, "--no-plots"));
		refused("--force", "evaluate", "--truth", sim, "--result", result, "--out", scores);
		assertEquals(0,
			run("evaluate", "--truth", sim, "--result", sim, "--out", scores, "--force"));
		refused("scores-position_error.png", "evaluate", "--truth", sim, "--result", sim, "--out",
			home.resolve("scores.txt"));
		refused("never replaced by", "simulate", "--out", result, "--force");
		refused("--force", "simulate", "--out", sim);
	}

	@Test
	void forceLeavesForeignFiles() throws IOException {
		Files.writeString(result.resolve("corrections.csv"), "mine");
		Files.createDirectory(result.resolve("notes"));
		Files.writeString(result.resolve("notes/montage.png"), "mine");
		assertEquals(0, run("resolve", home.resolve("movie.tif"), "--out", result, "--no-plots",
			"--force", "--threshold", "0.3"), err.toString());
		assertEquals("mine", Files.readString(result.resolve("corrections.csv")));
		assertEquals("mine", Files.readString(result.resolve("notes/montage.png")));
		assertTrue(Files.readString(result.resolve("parameters.json")).contains("0.3"));
		assertEquals(List.of("movie.tif", "result", "sim"), names(home));
	}

	@Test
	void ofTwoRunsIntoOneFolderTheSecondIsRefusedAtOnce() throws IOException {
		final Path out = home.resolve("out");
		final AtomicInteger second = new AtomicInteger(-1);
		final Engine whileItRuns = (movie, parameters, progress) -> {
			second.set(run("resolve", home.resolve("movie.tif"), "--out", out, "--force"));
			return TestImages.resolve(movie, parameters, progress);
		};
		assertEquals(0, run(whileItRuns, "resolve", home.resolve("movie.tif"), "--out", out));
		assertEquals(2, second.get());
		assertTrue(err.toString().contains("is being written by another run"), err.toString());
	}

	@Test
	void measurementsOfAFolderLieBesideIt() throws IOException {
		final Path first = Files.move(result, home.resolve("result.v1"));
		assertEquals(0, run("measure", first, "--no-plots"), err.toString());
		assertTrue(Files.exists(home.resolve("result.v1-measured/frames.csv")));
		refused("no folder that 'resolve' wrote", "measure", home.getRoot());
	}

	/** Refused with one sentence and status 2, and not a byte is changed. */
	private void refused(final String sentence, final Object... args) throws IOException {
		final Map<String, byte[]> before = contents();
		err.getBuffer().setLength(0);
		assertEquals(2, run(args), err.toString());
		assertEquals(1, err.toString().lines().count(), err.toString());
		assertTrue(err.toString().contains(sentence), err.toString());
		final Map<String, byte[]> after = contents();
		assertEquals(before.keySet(), after.keySet());
		before.forEach((name, bytes) -> assertArrayEquals(bytes, after.get(name), name));
	}

	private Map<String, byte[]> contents() throws IOException {
		final Map<String, byte[]> contents = new TreeMap<>();
		try (Stream<Path> files = Files.walk(home)) {
			for (final Path file : files.filter(Files::isRegularFile).toList())
				contents.put(home.relativize(file).toString(), Files.readAllBytes(file));
		}
		return contents;
	}

	private static List<String> names(final Path folder) throws IOException {
		try (Stream<Path> files = Files.list(folder)) {
			return files.map(f -> f.getFileName().toString()).sorted().toList();
		}
	}

	private int run(final Object... args) {
		return run(TestImages::resolve, args);
	}

	private int run(final Engine engine, final Object... args) {
		return KnotResolverMain.run(engine, Progress.NONE, new PrintWriter(new StringWriter()),
			new PrintWriter(err), Stream.of(args).map(Object::toString).toArray(String[]::new));
	}
}
