package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import ij.IJ;
import ij.ImagePlus;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.progress.Progress;

/** {@code simulate} and {@code evaluate} as a user types them. */
class SimulateCommandLineTest {

	private record Run(int status, String out, String err) {
	}

	@TempDir
	Path home;
	private Path out;

	@BeforeEach
	void nameFolder() {
		out = home.resolve("movie");
	}

	private static Run run(final String... args) {
		final StringWriter stdout = new StringWriter(), stderr = new StringWriter();
		final int status = KnotResolverMain.run((movie, parameters, progress) -> {
			throw new IllegalStateException("nothing is resolved here");
		}, Progress.NONE, new PrintWriter(stdout), new PrintWriter(stderr), args);
		return new Run(status, stdout.toString(), stderr.toString());
	}

	private Run simulate(final String... more) {
		final List<String> args = new ArrayList<>(List.of("simulate", "--out", out.toString(),
			"--length", "5", "--duration", "10", "--frames", "5", "--time-step", "0.02"));
		args.addAll(Arrays.asList(more));
		return run(args.toArray(String[]::new));
	}

	@Test
	void sentenceThatEndsWithAKeySpeaksOfTheOption() {
		final Run run = simulate("--persistence-length", "1");
		assertTrue(run.err.contains("a longer --persistence-length."), run.err);
		assertFalse(Files.exists(out));
	}

	@ParameterizedTest
	@CsvSource({"paper, 8", "paper, 16", "optical, 8", "optical, 16"})
	void writesAMovieItsTruthAndItsParameters(final String rendering, final String bits)
		throws IOException {
		final Run run = simulate("--rendering", rendering, "--bits", bits, "--bleaching-time",
			"100", "--others", "1", "--debris", "2");
		assertEquals(0, run.status, run.err);
		assertTrue(run.out.startsWith("5 frames of "), run.out);
		final ImagePlus image = IJ.openImage(out.resolve("movie.tif").toString());
		assertEquals(Integer.parseInt(bits), image.getBitDepth());
		assertEquals(5, image.getNFrames());
		assertEquals(0.106, image.getCalibration().pixelWidth, 1e-6);
		assertEquals("µm", image.getCalibration().getUnit());
		assertEquals(2, image.getCalibration().frameInterval, 1e-9);
		final Polyline first = ContoursCsv.read(out.resolve("contours.csv")).get(1);
		assertEquals(5 / 0.106, first.length(), 0.01);
		image.setSlice(1);
		final var middle = first.at(first.length() / 2);
		assertTrue(image.getProcessor().getf((int) Math.rint(middle.x()),
			(int) Math.rint(middle.y())) > 2 * image.getProcessor().getf(2, 2),
			"the filament is where the truth says");
		final JsonObject json = JsonParser
			.parseString(Files.readString(out.resolve("parameters.json"))).getAsJsonObject();
		assertEquals(5, json.getAsJsonObject("simulation").getAsJsonObject("filament").get("length")
			.getAsDouble());
		assertEquals(rendering, json.getAsJsonObject("rendering").get("rendering").getAsString());
	}

	@Test
	void sameSeedGivesSameBytesInAnyLocale() throws IOException {
		assertEquals(0, simulate("--seed", "4").status);
		final byte[] movie = Files.readAllBytes(out.resolve("movie.tif"));
		final String truth = Files.readString(out.resolve("contours.csv"));
		final Locale before = Locale.getDefault();
		Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
		try {
			assertEquals(0, simulate("--seed", "4", "--force").status);
		} finally {
			Locale.setDefault(before);
		}
		assertTrue(Arrays.equals(movie, Files.readAllBytes(out.resolve("movie.tif"))));
		assertEquals(truth, Files.readString(out.resolve("contours.csv")));
	}

	@CsvSource(delimiter = '|', value = { //
		"--length|0|must be 1 to 200 µm, but is 0; choose a value in that range.",
		"--length|NaN|must be 1 to 200 µm, but is NaN; choose a value in that range.",
		"--length|five|must be a number, but is 'five'.",
		"--density|-1|must be 0 to 1000 motors per µm², but is -1; choose a value in that range.",
		"--snr|loud|must be a number of dB from -30 to 100, or inf, but is 'loud'.",
		"--snr|nan|must be a number of dB from -30 to 100, or inf, but is 'nan'.",
		"--snr|200|must be -30 to 100 dB, but is 200; choose a value in that range.",
		"--frames|1000000|must be 2 to 10000, but is 1000000; choose a value in that range.",
		"--frames|1e6|must be a whole number, but is '1e6'.",
		"--frames|2.5|must be a whole number, but is '2.5'.",
		"--clamp|hard|must be pivot or direction or free, but is 'hard'.",
		"--seed|x|must be a whole number, but is 'x'.",
		"--bits|12|must be 8 or 16, but is 12; choose one of them.",
		"--pixel-size|0|must be 0.005 to 10 µm, but is 0; choose a value in that range.",
		"--margin|-1|must be 0 to 1000, but is -1; choose a value in that range.",
		"--time-step|NaN|must be 0.00001 to 0.1 s, but is NaN; choose a value in that range.",
		"--warm-up|-1|must be 0 to 100000 s, but is -1; choose a value in that range.",
		"--motor-stiffness|0|must be 1 to 10000 pN/µm, but is 0; choose a value in that range."})
	@ParameterizedTest
	void wrongValuesAreOneSentenceAndStatus2(final String option, final String value,
		final String sentence) throws IOException {
		final Run run = run("simulate", "--out", out.toString(), option, value);
		assertEquals(option + " " + sentence, run.err.strip());
		assertEquals(2, run.status);
		assertFalse(Files.exists(out));
	}

	@Test
	void aFolderThatMayNotBeWrittenIsStatus2() throws IOException {
		Files.writeString(out, "a file");
		final Run run = simulate();
		assertEquals(2, run.status);
		assertEquals(
			"--out " + out + " is a file, but the result needs a folder; choose another name.",
			run.err.strip());
	}

	@Test
	void anExistingMovieIsKeptUnlessForced() {
		assertEquals(0, simulate().status);
		assertEquals(2, simulate().status);
		assertEquals(0, simulate("--force").status);
	}

	@Test
	void evaluateScoresEveryFrame() throws IOException {
		assertEquals(0, simulate().status);
		final String truth = out.resolve("contours.csv").toString();
		final Path scores = home.resolve("scores.csv");
		final Run run = run("evaluate", "--truth", truth, "--result", truth, "--out",
			scores.toString());
		assertEquals(0, run.status, run.err);
		assertTrue(run.out.matches("(?s).*resolved \\(Frechet < 5 px\\) +100.0 %.*"), run.out);
		assertEquals(6, Files.readAllLines(scores).size());
		assertTrue(Files.readAllLines(scores).get(1).startsWith("1,1,0,1,1,"));
		for (final String figure : List.of("position_error", "dice", "frechet"))
			for (final String kind : List.of(".png", ".svg"))
				assertTrue(Files.size(home.resolve("scores-" + figure + kind)) > 0, figure + kind);
		final Path bare = home.resolve("bare.csv");
		assertEquals(0, run("evaluate", "--truth", out.toString(), "--result", truth, "--out",
			bare.toString(), "--no-plots").status);
		assertFalse(Files.exists(home.resolve("bare-dice.png")));
	}

	@Test
	void evaluateNamesTheFileThatIsWrong() throws IOException {
		final Path text = Files.writeString(home.resolve("notes.txt"), "hello\n");
		final Path truth = Files.writeString(home.resolve("truth.csv"),
			"frame,index,x_px,y_px\n1,0,1,1\n1,1,9,1\n");
		assertRefused(
			run("evaluate", "--truth", home + "/absent.csv", "--result", truth.toString()),
			"--truth cannot be used: There is no file " + home + "/absent.csv; check the path.");
		assertRefused(run("evaluate", "--truth", truth.toString(), "--result", text.toString()),
			"--result cannot be used: " + text + " must have the columns frame,index,x_px,y_px");
		final Path empty = Files.writeString(home.resolve("empty.csv"), "frame,index,x_px,y_px\n");
		assertRefused(run("evaluate", "--truth", empty.toString(), "--result", truth.toString()),
			"--truth has no frame to compare with; give contours");
		final Path nan = Files.writeString(home.resolve("nan.csv"),
			"frame,index,x_px,y_px\n1,0,1,1\n1,1,NaN,1\n");
		assertRefused(run("evaluate", "--truth", nan.toString(), "--result", truth.toString()),
			"--truth cannot be used: nan.csv, line 3: x_px must be a number, but is 'NaN'.");
		assertRefused(
			run("evaluate", "--truth", truth.toString(), "--result", truth.toString(), "--out",
				home + "/no/where.csv"),
			"--out " + home
				+ "/no/where.csv cannot be written; choose a file in a writable folder.");
		assertRefused(run("evaluate", "--truth", truth.toString()), "--result");
	}

	@Test
	void aReadOnlyFolderIsRefused() {
		assumeTrue(
			!home.toFile().canWrite()
				|| home.toFile().setWritable(false) && !home.toFile().canWrite(),
			"skipped: this user may write anywhere");
		try {
			assertRefused(simulate(), "is not writable");
		} finally {
			assertTrue(home.toFile().setWritable(true));
		}
	}

	private static void assertRefused(final Run run, final String part) {
		assertEquals(2, run.status);
		assertTrue(run.err.contains(part), run.err);
		assertEquals(1, run.err.strip().lines().count(), run.err);
	}
}
