package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

import org.junit.jupiter.api.Test;

/** What a reader prints is caught, what others print meanwhile is not. */
class ThreadPrintingTest {

	@Test
	void onlyTheThreadAndThoseItStartsPrintElsewhere() throws InterruptedException {
		final PrintStream before = System.out;
		final ByteArrayOutputStream usual = new ByteArrayOutputStream(),
			caught = new ByteArrayOutputStream();
		System.setOut(new PrintStream(usual, true, StandardCharsets.UTF_8));
		try {
			final Thread reader = new Thread(() -> {
				ThreadPrinting.to(new PrintStream(caught, true, StandardCharsets.UTF_8));
				System.out.println("µ of the reader");
				final Thread child = new Thread(() -> System.out.print(7));
				child.start();
				join(child);
				final Thread decoder = new Thread(() -> System.out.print(8), "Image Fetcher 0");
				decoder.start();
				join(decoder);
			});
			reader.start();
			reader.join();
			System.out.println("µ of others");
		} finally {
			System.setOut(before);
		}
		assertEquals(String.format("µ of the reader%n78"), caught.toString(StandardCharsets.UTF_8));
		assertEquals(String.format("µ of others%n"), usual.toString(StandardCharsets.UTF_8));
	}

	private static void join(final Thread thread) {
		try {
			thread.join();
		} catch (final InterruptedException e) {
			throw new IllegalStateException(e);
		}
	}
}
