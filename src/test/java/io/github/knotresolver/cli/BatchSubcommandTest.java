package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.imagej.TestImages;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/** A sheet or a folder of movies on the command line. */
class BatchSubcommandTest {

	@TempDir
	Path home;
	private Path out;
	private final AtomicInteger resolved = new AtomicInteger();
	private final StringWriter stdout = new StringWriter(), stderr = new StringWriter();

	@BeforeEach
	void saveMovies() throws IOException {
		out = home.resolve("out");
		Files.createDirectories(home.resolve("in/more"));
		TestImages.save(TestImages.movie(4, 8), home.resolve("in/a.tif"));
		TestImages.save(TestImages.movie(4, 16), home.resolve("in/b.tif"));
		TestImages.save(TestImages.movie(5, 8), home.resolve("in/more/a.tif"));
	}

	@Test
	void oneBadRowIsReportedTheRestGoOnAndFinishedRowsAreSkipped() throws IOException {
		final Path sheet = sheet("FileName,FolderPath,segThresh,remark", "a.tif,in,0.4,x",
			"b.tif,in,1.5,", "absent.tif,in,,", "a.tif,in/more,,");
		assertEquals(1, run(sheet, "--no-plots"));
		assertEquals(2, resolved.get());
		assertTrue(Files.exists(out.resolve("a/contours.csv")));
		assertTrue(Files.exists(out.resolve("a-2/contours.csv")));
		assertFalse(Files.exists(out.resolve("b")));
		assertTrue(stderr.toString().contains("b.tif: failed. threshold must be"),
			stderr.toString());
		assertTrue(stderr.toString().contains("absent.tif: failed. There is no file"),
			stderr.toString());
		assertTrue(stderr.toString().contains("Columns that mean nothing here: remark."));
		assertTrue(stdout.toString().contains("2 of 4 movies have a result."), stdout.toString());
		final List<String> list = Files.readAllLines(out.resolve("batch.csv"));
		assertEquals("line,movie,status,result,message", list.get(0));
		assertTrue(list.get(1).startsWith("2,") && list.get(1).contains(",finished,a,"));
		assertTrue(list.get(2).contains(",failed,,"), list.get(2));

		assertEquals(1, run(sheet, "--no-plots"));
		assertEquals(2, resolved.get());
		assertTrue(stdout.toString().contains("a.tif: skipped."), stdout.toString());
		assertEquals(1, run(sheet, "--no-plots", "--force"));
		assertEquals(4, resolved.get());
	}

	@Test
	void folderIsResolvedWithTheOptionsOfTheCommandLine() throws IOException {
		assertEquals(0, run(home.resolve("in"), "--no-plots", "--threshold", "0.3"));
		assertEquals(2, resolved.get());
		assertTrue(
			Files.readString(out.resolve("b/parameters.json")).contains("\"threshold\": 0.3"));
	}

	@Test
	void rowsOwnOptionsGoOverTheCommandLines() throws IOException {
		assertEquals(0, run(sheet("FileName,FolderPath,threshold", "a.tif,in,0.6", "b.tif,in,"),
			"--no-plots", "--threshold", "0.3"));
		assertTrue(
			Files.readString(out.resolve("a/parameters.json")).contains("\"threshold\": 0.6"));
		assertTrue(
			Files.readString(out.resolve("b/parameters.json")).contains("\"threshold\": 0.3"));
	}

	@Test
	void wrongUsageIsStatusTwo() throws IOException {
		assertEquals(2, run(home.resolve("absent.csv")));
		assertEquals(2, run(sheet("Name,Place", "a.tif,in")));
		assertEquals(2, run(Files.createDirectory(home.resolve("empty"))));
		assertTrue(stderr.toString().contains("has no movie"), stderr.toString());
		assertEquals(2, run(home.resolve("in"), "--threshold", "2"));
		out = Files.writeString(home.resolve("file"), "x");
		assertEquals(2, run(home.resolve("in")));
		assertEquals(0, resolved.get());
	}

	@Test
	void cancelKeepsWhatIsFinished() throws IOException {
		final Progress progress = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
			}

			@Override
			public boolean isCancelled() {
				return resolved.get() == 2;
			}
		};
		assertEquals(130, run(progress, home.resolve("in"), "--no-plots"));
		assertTrue(Files.exists(out.resolve("a/contours.csv")));
		assertFalse(Files.exists(out.resolve("b")));
		assertEquals(2, Files.readAllLines(out.resolve("batch.csv")).size());
	}

	private Path sheet(final String... lines) throws IOException {
		return Files.write(home.resolve("sheet.csv"), List.of(lines));
	}

	private int run(final Path input, final String... options) {
		return run(Progress.NONE, input, options);
	}

	private int run(final Progress progress, final Path input, final String... options) {
		final List<String> args = new ArrayList<>(
			List.of("batch", input.toString(), "--out", out.toString()));
		args.addAll(List.of(options));
		return KnotResolverMain.run((movie, parameters, p) -> {
			if (p.isCancelled())
				throw new CancelledException();
			resolved.incrementAndGet();
			p.checkCancelled();
			return TestImages.resolve(movie, parameters, p);
		}, progress, new PrintWriter(stdout), new PrintWriter(stderr), args.toArray(String[]::new));
	}
}
