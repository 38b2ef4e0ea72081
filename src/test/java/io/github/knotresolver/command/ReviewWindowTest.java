package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A result is reviewed with mouse and keys on a display of its own; skipped without Xvfb. */
class ReviewWindowTest {

	@TempDir
	Path home;

	@Test
	void aResultIsMendedSavedAndRepeatedHeadless() throws Exception {
		final Optional<Desktop> display = Desktop.open();
		assumeTrue(display.isPresent(), "Windows need a display: install Xvfb.");
		final Programs programs = new Programs(home);
		final Path result = home.resolve("my result");
		programs.knotresolver("resolve", programs.sample().toString(), "--no-plots", "--out",
			result.toString());
		final byte[] before = Files.readAllBytes(result.resolve("contours.csv"));
		Files.writeString(result.resolve("corrections.csv"),
			"filament,frame,kind,index,x_px,y_px\n1," + ReviewMain.SPOILED + ",through,0,2,2\n");
		Files.writeString(result.resolve("notes.txt"), "mine");
		final String printed;
		try (Desktop desktop = display.get()) {
			Files.createDirectories(home.resolve("user"));
			printed = desktop.run(programs, List.of("-Xmx1g", "-Djava.awt.headless=false",
				"-Duser.home=" + home.resolve("user"), "-Dplugins.dir=" + programs.installMenu()),
				ReviewMain.class.getName(), result.toString(), home.toString());
		}
		for (final String step : ReviewMain.STEPS)
			assertTrue(printed.contains("reached: " + step), step + ":\n" + printed);
		assertArrayEquals(before, Files.readAllBytes(home.resolve("mended.csv")));
		assertTrue(Files.exists(result.resolve("notes.txt")));
		final byte[] saved = Files.readAllBytes(result.resolve("contours.csv"));
		assertEquals(lines(before), lines(saved));
		final Path second = home.resolve("my second");
		final String line = Files.readString(home.resolve("recorded.ijm"))
			.replace("out=[" + result + "]", "out=[" + second + "]");
		programs.macros(line);
		for (final String file : List.of("contours.csv", "frames.csv", "filaments.csv"))
			assertEquals(-1, Files.mismatch(result.resolve(file), second.resolve(file)), file);
	}

	private static long lines(final byte[] text) {
		return new String(text).lines().filter(l -> !l.startsWith("#")).map(l -> l.split(",")[0])
			.distinct().count();
	}
}
