package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.progress.Progress;

/** The sample movie is knotted, small, and what its script makes. */
class SampleTest {

	private static final String FOLDER = "/io/github/knotresolver/sample/";

	@TempDir
	private Path folder;

	private static byte[] resource(final String name) throws IOException {
		try (InputStream in = SampleTest.class.getResourceAsStream(FOLDER + name)) {
			return in.readAllBytes();
		}
	}

	/** The options in the script that makes the sample. */
	private static List<String> options() throws IOException {
		final String script = Files.readString(Path.of("scripts", "make-sample"));
		final Matcher call = Pattern.compile("--out \\S+ \\\\\\R(.*?)\\R(?!\\t)", Pattern.DOTALL)
			.matcher(script);
		assertTrue(call.find(), "the script calls simulate");
		return List.of(call.group(1).replace("\\", " ").strip().split("\\s+"));
	}

	@Test
	void isWhatItsScriptMakes() throws IOException {
		final List<String> args = new ArrayList<>(List.of("simulate", "--out", folder + "/made"));
		args.addAll(options());
		final StringWriter err = new StringWriter();
		assertEquals(0, KnotResolverMain.run((movie, parameters, progress) -> {
			throw new IllegalStateException("nothing is resolved here");
		}, Progress.NONE, new PrintWriter(new StringWriter()), new PrintWriter(err),
			args.toArray(String[]::new)), err.toString());
		assertArrayEquals(resource("knotted-filament-truth.csv"),
			Files.readAllBytes(folder.resolve("made/contours.csv")));
		assertArrayEquals(resource("knotted-filament.tif"),
			Files.readAllBytes(folder.resolve("made/movie.tif")));
	}

	@Test
	void isSmallAndCrossesItself() throws IOException {
		assertTrue(resource("knotted-filament.tif").length <= 150 * 1024);
		final Path copy = folder.resolve("truth.csv");
		Files.write(copy, resource("knotted-filament-truth.csv"));
		final SortedMap<Integer, Polyline> truth = ContoursCsv.read(copy);
		assertEquals(24, truth.size());
		final long crossing = truth.values().stream()
			.filter(c -> !Crossings.of(c.resampled(1)).isEmpty()).count();
		assertTrue(crossing >= 10, crossing + " frames with crossings");
	}
}
