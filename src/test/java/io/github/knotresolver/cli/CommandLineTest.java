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
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.zip.ZipInputStream;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import ij.IJ;
import ij.ImagePlus;
import ij.gui.Roi;
import ij.io.RoiDecoder;
import io.github.knotresolver.imagej.TestImages;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;

/** What a user types, and what comes of it. */
class CommandLineTest {

	private static final List<String> FILES = List.of("MTdata.csv", "RoiSet.zip", "contours.csv",
		"filaments.csv", "frames.csv", "montage.png", "overlay.avi", "overlay.png", "overlay.tif",
		"parameters.json", "statsSummary.txt", "summary.csv");

	@TempDir
	Path home;
	private Path movie;
	private Path out;

	@BeforeEach
	void saveMovie() {
		movie = TestImages.save(TestImages.movie(5, 8), home.resolve("movie.tif"));
		out = home.resolve("result");
	}

	@Test
	void resolvesAMovieIntoAFolder() throws IOException {
		final Run run = resolve(movie);
		assertEquals("", run.err);
		assertEquals(0, run.status);
		assertTrue(run.out.startsWith("movie.tif: 4 of 5 frames resolved, median length "),
			run.out);
		assertTrue(run.out.contains("Frames lost: 2"), run.out);
		assertTrue(names(out).containsAll(FILES), names(out).toString());
		assertEquals(List.of("movie.tif", "result"), names(home));
		assertEquals("2,lost,\"The filament, it seems, is \"\"gone\"\".\",,,,0,0,0,,,µm,1,,0",
			Files.readAllLines(out.resolve("frames.csv")).get(2));
	}

	@Test
	void sameInputGivesSameBytesInAnyLocale() throws IOException {
		assertEquals(0, resolve(movie, "--threads", "1").status);
		final Map<String, byte[]> first = contents(out);
		final Locale before = Locale.getDefault();
		Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
		try {
			assertEquals(0, resolve(movie, "--threads", "2", "--force").status);
		} finally {
			Locale.setDefault(before);
		}
		final Map<String, byte[]> second = contents(out);
		assertEquals(first.keySet(), second.keySet());
		first.forEach((name, bytes) -> assertTrue(Arrays.equals(bytes, second.get(name)), name));
	}

	@Test
	void withoutPlotsThereAreNone() throws IOException {
		assertEquals(0, resolve(movie, "--no-plots").status);
		assertFalse(names(out).contains("overlay.png"));
		assertFalse(names(out).contains("overlay.avi"));
		assertTrue(names(out).contains("montage.png"));
	}

	@Test
	void refineCanBeSwitchedOff() throws IOException {
		assertEquals(0, resolve(movie, "--no-refine").status);
		assertTrue(Files.readString(out.resolve("parameters.json")).contains("\"refine\": false"));
		assertEquals(0, resolve(movie, "--refine", "--force").status);
		assertTrue(Files.readString(out.resolve("parameters.json")).contains("\"refine\": true"));
	}

	@Test
	void roisOfAHyperstackHaveItsPositions() throws IOException {
		final ImagePlus two = IJ.createHyperStack("two", 80, 60, 2, 1, 3, 8);
		two.getStack().getProcessor(two.getStackIndex(2, 1, 1)).set(3, 3, 9);
		assertEquals(0, resolve(save(two, "two.tif"), "--channel", "2", "--no-plots").status);
		try (ZipInputStream zip = new ZipInputStream(
			Files.newInputStream(out.resolve("RoiSet.zip")))) {
			assertEquals("knot-0001.roi", zip.getNextEntry().getName());
			assertEquals("knot-0003.roi", zip.getNextEntry().getName());
			final Roi roi = RoiDecoder.openFromByteArray(zip.readAllBytes());
			assertEquals(List.of(2, 3), List.of(roi.getCPosition(), roi.getTPosition()));
		}
	}

	@Test
	void helpAndVersion() {
		final Run help = run(TestImages::resolve, "resolve", "--help");
		assertEquals(0, help.status);
		for (final String option : List.of("--fixed-end", "--threshold", "--[no-]refine",
			"--[no-]plots", "--length-model", "--z-as-time", "--force", "--corrections"))
			assertTrue(help.out.contains(option), option);
		assertTrue(run(TestImages::resolve, "--help").out.contains("resolve"));
		assertTrue(run(TestImages::resolve, "--version").out.startsWith("KnotResolver "));
	}

	@Test
	void wrongUsageIsStatus2() {
		assertRefused(run(TestImages::resolve), "Say what to do");
		assertRefused(run(TestImages::resolve, "resolve", movie.toString()), "--out");
		assertRefused(run(TestImages::resolve, "resolve", "--out", out.toString()), "Name a movie");
		assertRefused(run(TestImages::resolve, "untangle", movie.toString()), "untangle");
		assertRefused(resolve(movie, "--speed", "9"), "--speed");
		assertRefused(resolve(movie, "another.tif"), "another.tif");
		assertRefused(resolve(movie, "--sample"), "--sample");
	}

	@Test
	void wrongValuesAreStatus2() {
		assertRefused(resolve(movie, "--threshold", "1.5"),
			"--threshold must be a number from 0 to 1");
		assertRefused(resolve(movie, "--contraction-bias", "x"),
			"--contraction-bias must be a number");
		assertRefused(resolve(movie, "--fixed-end", "500,3"),
			"--fixed-end must lie inside the image of 80 x 60");
		assertRefused(resolve(movie, "--channel", "2"), "--channel must be from 1 to 1");
		assertRefused(resolve(movie, "--frames", "4-9"),
			"--frames names frame 9, but the movie has 5");
		assertRefused(resolve(movie, "--corrections", home + "/absent.csv"), "absent.csv");
	}

	@Test
	void unreadableMoviesAreStatus2() throws IOException {
		final byte[] tiff = Files.readAllBytes(movie);
		assertRefused(resolve(home.resolve("absent.tif")), "There is no file");
		assertRefused(resolve(home), "each file is one frame");
		assertRefused(resolve(file("empty.tif", new byte[0])), "is empty");
		assertRefused(resolve(file("cut.tif", Arrays.copyOf(tiff, tiff.length / 2))), "is cut off");
		assertRefused(resolve(file("header.tif", Arrays.copyOf(tiff, 20))), "is cut off");
		assertRefused(resolve(file("text.tif", "not a movie\n".getBytes())), "is not an image");
		assertRefused(resolve(file("text.txt", "1 2 3\n".getBytes())), "is not an image");
	}

	@Test
	void moviesThatAreNoneAreStatus2() {
		final ImagePlus one = TestImages.movie(1, 8);
		assertRefused(resolve(save(one, "one.tif")), "one frame only");
		final ImagePlus z = TestImages.movie(5, 8);
		z.setDimensions(1, 5, 1);
		assertRefused(resolve(save(z, "z.tif")), "--z-as-time");
		final ImagePlus zt = TestImages.movie(6, 8);
		zt.setDimensions(1, 2, 3);
		assertRefused(resolve(save(zt, "zt.tif")), "Z Project");
		final ImagePlus rgb = IJ.createHyperStack("rgb", 9, 9, 1, 1, 4, 24);
		rgb.getStack().getProcessor(2).set(3, 3, 0xff0000);
		assertRefused(resolve(save(rgb, "rgb.tif")), "RGB");
		assertRefused(resolve(save(IJ.createHyperStack("flat", 9, 9, 1, 1, 4, 16), "flat.tif")),
			"equal in every frame");
	}

	@Test
	void zStackIsAMovieIfTheUserSaysSo() {
		final ImagePlus z = TestImages.movie(5, 16);
		z.setDimensions(1, 5, 1);
		final Run run = resolve(save(z, "z.tif"), "--z-as-time");
		assertEquals("", run.err);
		assertEquals(0, run.status);
	}

	@Test
	void foldersThatMayNotBeWrittenAreStatus2() throws IOException {
		final Path file = file("file", new byte[]{1});
		assertRefused(
			run(TestImages::resolve, "resolve", movie.toString(), "--out", file.toString()),
			"is a file");
		assertRefused(
			run(TestImages::resolve, "resolve", movie.toString(), "--out", file + "/deep"),
			"is a file");
		final Path others = Files.createDirectory(home.resolve("others"));
		Files.writeString(others.resolve("thesis.txt"), "x");
		assertRefused(run(TestImages::resolve, "resolve", movie.toString(), "--force", "--out",
			others.toString()), "not a result");
	}

	@Test
	void existingResultIsReplacedOnlyWithForce() throws IOException {
		assertEquals(0, resolve(movie).status);
		final byte[] before = Files.readAllBytes(out.resolve("summary.csv"));
		final Run again = resolve(movie, "--threshold", "0.3");
		assertEquals(2, again.status);
		assertOneLine(again, "--force");
		assertTrue(Arrays.equals(before, Files.readAllBytes(out.resolve("summary.csv"))));
		assertEquals(0, resolve(movie, "--threshold", "0.3", "--force").status);
		assertFalse(Arrays.equals(before, Files.readAllBytes(out.resolve("summary.csv"))));
	}

	@Test
	void failureIsStatus1WithOneLineAndNothingWritten() throws IOException {
		final Engine none = (m, p, progress) -> {
			throw new UserException("No filament was found.");
		};
		final Engine broken = (m, p, progress) -> {
			throw new ArrayIndexOutOfBoundsException("Index 7\nout of bounds");
		};
		final Engine large = (m, p, progress) -> {
			throw new OutOfMemoryError("Java heap space");
		};
		assertFailed(1, none, "No filament was found.");
		assertFailed(1, broken, "please report it");
		assertFailed(1, large, "not enough memory");
	}

	@Test
	void aBugNamesItsLogAndDebugPrintsItsTrace() throws IOException {
		final Engine broken = (m, p, progress) -> {
			throw new IllegalArgumentException("The radius must be at least 1, but is 0.");
		};
		final String[] args = {"resolve", movie.toString(), "--out", out.toString()};
		final Run run = run(broken, args);
		assertEquals(1, run.status);
		assertOneLine(run, "bug");
		final Path log = Path.of(run.err.replaceFirst("(?s).* attach (.*), which .*", "$1"));
		assertTrue(Files.readString(log).contains("CommandLineTest"), run.err);
		final Run debug = run(broken, "resolve", "--debug", args[1], args[2], args[3]);
		assertEquals(1, debug.status);
		assertTrue(debug.err.contains("at " + CommandLineTest.class.getName()), debug.err);
		assertOneLine(run(broken, args), "bug");
	}

	@Test
	void cancelIsStatus130WithNothingWritten() throws IOException {
		final Engine cancelled = (m, p, progress) -> {
			throw new CancelledException();
		};
		assertFailed(130, cancelled, "Cancelled");
	}

	private void assertFailed(final int status, final Engine engine, final String text)
		throws IOException {
		final Run run = run(engine, "resolve", movie.toString(), "--out", out.toString());
		assertEquals(status, run.status);
		assertOneLine(run, text);
		assertEquals(List.of("movie.tif"), names(home));
	}

	private void assertRefused(final Run run, final String text) {
		assertEquals(2, run.status, run.err);
		assertOneLine(run, text);
		assertFalse(Files.exists(out));
	}

	private static void assertOneLine(final Run run, final String text) {
		assertEquals(1, run.err.lines().count(), run.err);
		assertTrue(run.err.contains(text), run.err);
		assertEquals("", run.out);
	}

	private Path save(final ImagePlus image, final String name) {
		return TestImages.save(image, home.resolve(name));
	}

	private Path file(final String name, final byte[] bytes) throws IOException {
		return Files.write(home.resolve(name), bytes);
	}

	private Run resolve(final Path file, final String... options) {
		final List<String> args = new ArrayList<>(
			List.of("resolve", file.toString(), "--out", out.toString()));
		args.addAll(List.of(options));
		return run(TestImages::resolve, args.toArray(String[]::new));
	}

	private static Run run(final Engine engine, final String... args) {
		final StringWriter out = new StringWriter(), err = new StringWriter();
		final int status = KnotResolverMain.run(engine, Progress.NONE, new PrintWriter(out),
			new PrintWriter(err), args);
		return new Run(status, out.toString(), err.toString());
	}

	private static Map<String, byte[]> contents(final Path folder) throws IOException {
		final Map<String, byte[]> contents = new TreeMap<>();
		for (final String name : names(folder))
			contents.put(name, Files.readAllBytes(folder.resolve(name)));
		return contents;
	}

	private static List<String> names(final Path folder) throws IOException {
		try (Stream<Path> files = Files.list(folder)) {
			return files.map(f -> f.getFileName().toString()).sorted().toList();
		}
	}

	private record Run(int status, String out, String err) {
	}
}
