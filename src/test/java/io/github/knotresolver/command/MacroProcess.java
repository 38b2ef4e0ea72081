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

/** Java in a process of its own, with the menu installed as in a Fiji. */
final class MacroProcess {

	private final Path home;

	/** @param home an empty folder */
	MacroProcess(final Path home) {
		this.home = home;
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

	/** Runs a main class, and gives what it printed. */
	String java(final Map<String, String> environment, final List<String> options,
		final String... program) throws Exception {
		final Path log = home.resolve("log.txt");
		final List<String> command = new ArrayList<>(
			List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
				"-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
		command.addAll(options);
		command.addAll(List.of("-cp", System.getProperty("java.class.path")));
		command.addAll(List.of(program));
		final ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true)
			.redirectOutput(log.toFile());
		builder.environment().putAll(environment);
		final Process process = builder.start();
		if (!process.waitFor(3, TimeUnit.MINUTES)) {
			process.destroyForcibly();
			throw new AssertionError("Still running: " + Files.readString(log));
		}
		return Files.readString(log);
	}
}
