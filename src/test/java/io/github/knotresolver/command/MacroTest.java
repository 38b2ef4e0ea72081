package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.imagej.TestImages;

/**
 * Macros without a display, in a process of their own, with ImageJ patched as
 * Fiji does it; and the same by SciJava's {@code --headless --run} and on the
 * command line.
 */
class MacroTest {

	@TempDir
	Path home;

	@Test
	void macroCommandAndCommandLineGiveTheSameContours() throws Exception {
		final Path macro = out("macro"), hidden = out("hidden"), command = out("command"),
			line = out("line"), file = out("file");
		final String log = macros("run(\"Knotted Filament\");",
			"run(\"Resolve Filament...\", \"threads=1 plots=false out=[" + macro + "]\");",
			"setBatchMode(true); run(\"Knotted Filament\");",
			"n = 1; run(\"Resolve Filament...\", \"threads=&n plots=false out='" + hidden
				+ "'\");");
		assertTrue(Files.exists(macro.resolve("contours.csv")), log);
		final String run = java(List.of("-Djava.awt.headless=true"),
			"io.github.knotresolver.command.HeadlessRunMain", "--headless", "--run",
			ResolveFilamentCommand.class.getName(),
			"movie=\"" + sample() + "\",out=\"" + command + "\",plots=\"false\",threads=\"2\"");
		assertTrue(Files.exists(command.resolve("contours.csv")), run);
		java(List.of(), "io.github.knotresolver.cli.KnotResolverMain", "resolve", "--sample",
			"--no-plots", "--out", line.toString());
		java(List.of(), "io.github.knotresolver.cli.KnotResolverMain", "resolve",
			sample().toString(), "--no-plots", "--out", file.toString());
		final String expected = Files.readString(line.resolve("contours.csv"));
		for (final Path other : List.of(macro, hidden, command, file))
			assertEquals(expected, Files.readString(other.resolve("contours.csv")),
				other.toString());
	}

	@Test
	void wrongMacroEndsWithOneSentenceAndWritesNothing() throws Exception {
		assertStops("threshold must be a number from 0 to 1", "threshold=1.5");
		assertStops("iterations must be a whole number from 0 to 1000, but is 'abc'",
			"iterations=abc");
		assertStops("There is no key 'treshold'; the keys are image, movie, fixed_end, threshold",
			"treshold=0.4");
		assertStops("resolver must be movie or paper, but is 'best'", "resolver=best");
	}

	@Test
	void exampleMacrosResolveAMovieAndAFolder() throws Exception {
		final Path one = home.resolve("one"), all = home.resolve("all");
		String log = macro(Path.of("scripts/examples/resolve-one.ijm"), sample() + "," + one);
		assertTrue(Files.exists(one.resolve("contours.csv")), log);
		log = macro(Path.of("scripts/examples/resolve-folder.ijm"), home + "," + all);
		assertEquals(Files.readString(one.resolve("contours.csv")),
			Files.readString(all.resolve("knotted-filament/contours.csv")), log);
	}

	private void assertStops(final String sentence, final String option) throws Exception {
		final Path after = home.resolve("after.txt"), out = out("none");
		final String log = macros("run(\"Knotted Filament\");",
			"run(\"Resolve Filament...\", \"" + option + " out=[" + out + "]\");",
			"File.saveString(\"on\", \"" + after + "\");");
		assertTrue(log.contains(sentence), log);
		assertFalse(log.contains("\tat "), log);
		assertFalse(Files.exists(out), log);
		assertFalse(Files.exists(after), "The macro went on after: " + log);
	}

	private Path out(final String name) {
		return home.resolve(name + " folder");
	}

	private Path sample() throws IOException {
		final Path file = home.resolve("knotted-filament.tif");
		if (!Files.exists(file))
			TestImages.save(io.github.knotresolver.imagej.SampleMovie.open(), file);
		return file;
	}

	private String macros(final String... lines) throws Exception {
		return macro(Files.writeString(home.resolve("macro.ijm"), String.join("\n", lines)), "");
	}

	private String macro(final Path file, final String argument) throws Exception {
		return java(
			List.of("-Djava.awt.headless=true", "--add-opens=java.base/java.lang=ALL-UNNAMED",
				"-Dplugins.dir=" + installMenu()),
			"io.github.knotresolver.command.HeadlessMacroMain", file.toString(), argument);
	}

	/** A jar with the menu, as in a Fiji's plugins folder; the classes are on the path. */
	private Path installMenu() throws IOException {
		final Path folder = Files.createDirectories(home.resolve("plugins"));
		try (
			JarOutputStream jar = new JarOutputStream(
				Files.newOutputStream(folder.resolve("KnotResolver_-test.jar")));
			InputStream menu = CommandPlugIn.class.getResourceAsStream("/plugins.config")) {
			jar.putNextEntry(new JarEntry("plugins.config"));
			menu.transferTo(jar);
			jar.closeEntry();
		}
		return home;
	}

	private String java(final List<String> options, final String... program) throws Exception {
		final Path log = home.resolve("log.txt");
		final List<String> command = new ArrayList<>(
			List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
				"-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
		command.addAll(options);
		command.addAll(List.of("-cp", System.getProperty("java.class.path")));
		command.addAll(List.of(program));
		final Process process = new ProcessBuilder(command).redirectErrorStream(true)
			.redirectOutput(log.toFile()).start();
		if (!process.waitFor(3, TimeUnit.MINUTES)) {
			process.destroyForcibly();
			throw new AssertionError("Still running: " + Files.readString(log));
		}
		return Files.readString(log);
	}
}
