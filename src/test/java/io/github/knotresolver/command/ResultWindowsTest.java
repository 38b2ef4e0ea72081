package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.imagej.TestImages;

/** The windows of a result lead to its frames, on a display of its own; skipped without Xvfb. */
class ResultWindowsTest {

	@TempDir
	Path home;

	@Test
	void everyNumberLeadsToItsFrame() throws Exception {
		final Optional<Desktop> display = Desktop.open();
		assumeTrue(display.isPresent(), "Windows need a display: install Xvfb.");
		TestImages.save(SampleMovie.open(), home.resolve("movie.tif"));
		Files.copy(home.resolve("movie.tif"), home.resolve("second.tif"));
		Files.writeString(home.resolve("sheet.csv"),
			"FileName,FolderPath,requiresManual\nmovie.tif,.,False\nsecond.tif,.,True\n");
		final Programs programs = new Programs(home);
		final String printed;
		try (Desktop desktop = display.get()) {
			Files.createDirectories(home.resolve("user"));
			printed = desktop.run(programs, List.of("-Xmx1g", "-Djava.awt.headless=false",
				"-Duser.home=" + home.resolve("user"), "-Dplugins.dir=" + programs.installMenu()),
				ResultWindowsMain.class.getName(), home.toString());
		}
		for (final String step : ResultWindowsMain.STEPS)
			assertTrue(printed.contains("reached: " + step), step + ":\n" + printed);
	}
}
