package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.imagej.TestImages;

/** Ctrl-C in a real process. */
class InterruptionTest {

	private static final long INTERRUPT_BIT = 1L << 1;

	@TempDir
	Path home;

	@Test
	void interruptEndsWithStatus130AndLeavesNothing() throws IOException, InterruptedException {
		final Path movie = TestImages.save(TestImages.movie(4, 8), home.resolve("movie.tif"));
		final Path err = home.resolve("err.txt");
		final Process process = new ProcessBuilder(
			Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
			System.getProperty("java.class.path"), TruthMain.class.getName(), "resolve",
			movie.toString(), "--out", home.resolve("result").toString())
			.redirectError(err.toFile()).start();
		try (BufferedReader out = process.inputReader()) {
			assertEquals("started", out.readLine());
			assumeTrue(listensToInterrupts(process),
				"This session started with interrupts switched off.");
			new ProcessBuilder("kill", "-INT", Long.toString(process.pid())).start().waitFor();
			assertTrue(process.waitFor(60, TimeUnit.SECONDS));
			assertEquals(130, process.exitValue());
		} finally {
			process.destroyForcibly();
		}
		assertEquals(List.of("Cancelled; nothing was written."), Files.readAllLines(err));
		try (Stream<Path> files = Files.list(home)) {
			assertEquals(List.of("err.txt", "movie.tif"),
				files.map(f -> f.getFileName().toString()).sorted().toList());
		}
	}

	/** A process started with SIGINT ignored goes on ignoring it. */
	private static boolean listensToInterrupts(final Process process) throws IOException {
		final Path status = Path.of("/proc", Long.toString(process.pid()), "status");
		if (!Files.exists(status))
			return !System.getProperty("os.name").startsWith("Windows");
		final String ignored = Files.readAllLines(status).stream()
			.filter(l -> l.startsWith("SigIgn:")).findFirst().orElseThrow().split("\\s+")[1];
		return (Long.parseUnsignedLong(ignored, 16) & INTERRUPT_BIT) == 0;
	}
}
