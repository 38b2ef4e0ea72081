package io.github.knotresolver.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A display of its own for tests of windows, made by Xvfb; nobody sees it. */
final class Desktop implements AutoCloseable {

	/**
	 * Read by Java's toolkit: how many milliseconds it sleeps at most before it looks for events. By
	 * itself it sleeps the longer (up to half a second) the fewer come, through those that the robot
	 * has already fetched, too: each wait for the robot takes seconds where nothing else is going on,
	 * and two clicks are no double click any more.
	 */
	private static final String SLEEP = "_AWT_MAX_POLL_TIMEOUT", SLEEP_MILLIS = "10";

	private final Process server;
	private final String display;

	private Desktop(final Process server, final String display) {
		this.server = server;
		this.display = display;
	}

	/** @return a new display; empty if this machine has no Xvfb */
	static Optional<Desktop> open() throws IOException {
		final boolean present = Arrays.stream(System.getenv().getOrDefault("PATH", "").split(":"))
			.anyMatch(folder -> Files.isExecutable(Path.of(folder, "Xvfb")));
		if (!present)
			return Optional.empty();
		final Process server = new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0",
			"1440x1000x24", "-nolisten", "tcp").redirectError(ProcessBuilder.Redirect.DISCARD)
			.start();
		// Its number comes as a line as soon as it can be used.
		final StringBuilder number = new StringBuilder();
		for (int c = server.getInputStream().read(); c >= '0'; c = server.getInputStream().read())
			number.append((char) c);
		if (number.isEmpty()) {
			server.destroy();
			return Optional.empty();
		}
		return Optional.of(new Desktop(server, ":" + number));
	}

	/** Runs ImageJ's class with this display; returns what it printed. */
	String run(final Programs programs, final List<String> options, final String... program)
		throws IOException, InterruptedException {
		return programs.run(Map.of("DISPLAY", display, SLEEP, SLEEP_MILLIS),
			Programs.javaCommand(options, program));
	}

	@Override
	public void close() throws InterruptedException {
		server.destroy();
		server.waitFor();
	}
}
