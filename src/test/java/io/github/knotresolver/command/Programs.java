package io.github.knotresolver.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;

import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.imagej.TestImages;

/**
 * Programs in processes of their own, with what they need, in a folder of their
 * own.
 *
 * @param home the folder
 */
record Programs(Path home) {

	private static final int MINUTES = 10;

	/** Runs Java with the class path of the tests; returns what it printed. */
	String java(final List<String> options, final String... program)
		throws IOException, InterruptedException {
		return run(Map.of(), javaCommand(options, program));
	}

	/** The same, as a command line. */
	static List<String> javaCommand(final List<String> options, final String... program) {
		final List<String> command = new ArrayList<>(
			List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
				"-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
		command.addAll(options);
		command.addAll(List.of("-cp", System.getProperty("java.class.path")));
		command.addAll(List.of(program));
		return command;
	}

	/** Runs a program; returns what it printed. */
	String run(final Map<String, String> environment, final List<String> command)
		throws IOException, InterruptedException {
		final Path log = Files.createTempFile(home, "log", ".txt");
		final ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true)
			.redirectOutput(log.toFile());
		builder.environment().putAll(environment);
		final Process process = builder.start();
		if (!process.waitFor(MINUTES, TimeUnit.MINUTES)) {
			process.destroyForcibly();
			throw new AssertionError("Still running: " + Files.readString(log));
		}
		return Files.readString(log);
	}

	/** Runs a macro without a display, with ImageJ patched as Fiji does it. */
	String macro(final Path file, final String argument) throws IOException, InterruptedException {
		return java(
			List.of("-Djava.awt.headless=true", "--add-opens=java.base/java.lang=ALL-UNNAMED",
				"-Dplugins.dir=" + installMenu()),
			"io.github.knotresolver.command.HeadlessMacroMain", file.toString(), argument);
	}

	/** A macro of these lines. */
	String macros(final String... lines) throws IOException, InterruptedException {
		return macro(Files.writeString(home.resolve("macro.ijm"), String.join("\n", lines)), "");
	}

	/** The command line. */
	String knotresolver(final String... arguments) throws IOException, InterruptedException {
		final List<String> program = new ArrayList<>(
			List.of("io.github.knotresolver.cli.KnotResolverMain"));
		program.addAll(List.of(arguments));
		return java(List.of("-Djava.awt.headless=true"), program.toArray(String[]::new));
	}

	/** A jar with the menu, as in a Fiji's plugins folder; the classes are on the path. */
	Path installMenu() throws IOException {
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

	/** The sample as a file. */
	Path sample() {
		final Path file = home.resolve(SampleMovie.NAME);
		return Files.exists(file) ? file : TestImages.save(SampleMovie.open(), file);
	}
}
