package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * Plain ImageJ with its menu, dialogs, recorder, ROI Manager and tables on a
 * display of its own; skipped where there is no Xvfb.
 */
class DialogsTest {

	@TempDir
	Path home;

	@TestFactory
	Stream<DynamicTest> everySceneEndsAsItShould() throws Exception {
		final String printed = play(DialogsMain.class, home);
		return Stream.concat(
			DialogsMain.names().stream()
				.map(name -> DynamicTest.dynamicTest(name,
					() -> assertTrue(printed.lines().anyMatch((DialogsMain.PASSED + name)::equals),
						printed))),
			Stream.of(DynamicTest.dynamicTest("the menu gives what the command line gives",
				this::assertMenuIsCommandLine)));
	}

	/** Macros, scripts and Commands are compared with the command line in other tests. */
	private void assertMenuIsCommandLine() throws Exception {
		final Path line = home.resolve("line");
		new Programs(home).knotresolver("resolve", "--sample", "--no-plots", "--out",
			line.toString());
		assertEquals(-1, Files.mismatch(line.resolve("contours.csv"),
			home.resolve(DialogsMain.RECORDED).resolve("contours.csv")));
	}

	@Test
	void nothingPilesUpOverFiftyRuns() throws Exception {
		final String printed = play(RepeatedRunsMain.class, home.resolve("out"));
		final Matcher counts = Pattern.compile("(.*): (\\d+) -> (\\d+)").matcher(printed);
		int found = 0;
		for (; counts.find(); found++) {
			final long before = Long.parseLong(counts.group(2));
			final long allowed = counts.group(1).startsWith("memory") ? before + 6 : before;
			assertTrue(Long.parseLong(counts.group(3)) <= allowed, printed);
		}
		assertEquals(7, found, printed);
	}

	private String play(final Class<?> program, final Path argument) throws Exception {
		final Optional<Desktop> display = Desktop.open();
		assumeTrue(display.isPresent(), "Windows need a display: install Xvfb.");
		try (Desktop desktop = display.get()) {
			final Programs programs = new Programs(home);
			Files.createDirectories(home.resolve("user"));
			return desktop.run(programs, List.of("-Xmx1g", "-Djava.awt.headless=false",
				"-Duser.home=" + home.resolve("user"), "-Dplugins.dir=" + programs.installMenu()),
				program.getName(), argument.toString());
		}
	}
}
