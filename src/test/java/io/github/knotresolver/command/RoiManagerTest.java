package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Polylines in ImageJ's own ROI Manager are measured. ImageJ has none without a
 * display, so a virtual one is started; without Xvfb the tests are skipped.
 */
class RoiManagerTest {

	@TempDir
	Path home;
	private Desktop desktop;

	@BeforeEach
	void openDesktop() throws IOException {
		final Optional<Desktop> opened = Desktop.open();
		assumeTrue(opened.isPresent(), "This machine has no Xvfb.");
		desktop = opened.get();
	}

	@AfterEach
	void closeDesktop() throws InterruptedException {
		if (desktop != null)
			desktop.close();
	}

	@Test
	void linesAreMeasuredOnTheirFrames() throws Exception {
		for (final String mode : List.of("false", "true")) {
			final Path out = home.resolve("measured " + mode);
			final String log = macro("setBatchMode(" + mode + ");", movie("1, 1, 4"),
				lines(61, "Stack.setFrame(frames[k]);"), measure(out));
			assertMeasured(out, log);
		}
	}

	/** As many open a time series: its frames are slices. */
	@Test
	void slicesAreFrames() throws Exception {
		final Path out = home.resolve("measured");
		assertMeasured(out,
			macro(movie("1, 4, 1"), lines(61, "setSlice(frames[k]);"), measure(out)));
	}

	/** ROIs of a second channel stand on slices 2, 6 and 8 of eight. */
	@Test
	void channelsAreNotFrames() throws Exception {
		final Path out = home.resolve("measured");
		assertMeasured(out, macro("newImage('m', '8-bit black', 100, 80, 8);",
			properties("2, 1, 4"), lines(61, "Stack.setPosition(2, 1, frames[k]);"), measure(out)));
	}

	@Test
	void whatCannotBeMeasuredIsSaidInOneSentence() throws Exception {
		assertStops("None of the 4 frames has a contour of 3 points or more",
			lines(2, "Stack.setFrame(frames[k]);"));
		assertStops("has two polylines on frame 1", lines(5, "Stack.setFrame(1);"));
		assertStops("There is no polyline in the ROI Manager",
			"makeRectangle(1, 1, 5, 5); roiManager('Add');");
	}

	private void assertStops(final String sentence, final String lines) throws Exception {
		final Path said = home.resolve("said.txt");
		final String log = macro("setBatchMode(true);", movie("1, 1, 4"), lines,
			"File.saveString(call('io.github.knotresolver.command.WindowMacroMain.refusal'), '"
				+ said + "');");
		assertTrue(Files.readString(said).contains(sentence), Files.readString(said) + log);
	}

	/** 60 pixels of 0.1 µm, straight; nothing in frame 2. */
	private static void assertMeasured(final Path out, final String log) throws IOException {
		assertTrue(Files.exists(out.resolve("frames.csv")), log);
		final List<String> frames = Files.readAllLines(out.resolve("frames.csv"));
		assertEquals(5, frames.size(), log);
		final String[] third = frames.get(3).split(",");
		assertEquals(4, Double.parseDouble(third[1]), log);
		assertEquals(6, Double.parseDouble(third[2]), 1e-3, log);
		assertTrue(frames.get(2).startsWith("2,2,,"), frames.get(2));
		assertTrue(frames.get(1).endsWith("µm,1/µm,s,1"), frames.get(1));
		assertTrue(Files.readAllLines(out.resolve("contours.csv")).get(30).contains(",20.000,"),
			Files.readAllLines(out.resolve("contours.csv")).get(30));
	}

	private static String movie(final String dimensions) {
		return "newImage('m', '8-bit black', 100, 80, 4);" + properties(dimensions);
	}

	private static String properties(final String dimensions) {
		return "Stack.setDimensions(" + dimensions + "); setVoxelSize(0.1, 0.1, 1, 'micron');"
			+ "Stack.setFrameInterval(2);";
	}

	/** Polylines of some points on frames 1, 3 and 4. */
	private static String lines(final int points, final String choose) {
		return "n = " + points + "; x = newArray(n); y = newArray(n);"
			+ "for (i = 0; i < n; i++) { x[i] = 10 + 60 * i / (n - 1); y[i] = 20; }"
			+ "frames = newArray(1, 3, 4); for (k = 0; k < 3; k++) {" + choose
			+ "makeSelection('polyline', x, y); roiManager('Add'); }";
	}

	private static String measure(final Path out) {
		return "run('Measure Contours...', 'plots=false show=false out=[" + out + "]');";
	}

	private String macro(final String... lines) throws Exception {
		final Path file = Files.writeString(home.resolve("macro.ijm"), String.join("\n", lines));
		final Programs programs = new Programs(home);
		return desktop.run(programs,
			List.of("-Djava.awt.headless=false", "-Dplugins.dir=" + programs.installMenu()),
			"io.github.knotresolver.command.WindowMacroMain", file.toString());
	}
}
