
package io.github.knotresolver.imagej;

import java.awt.GraphicsEnvironment;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.function.Supplier;

/**
 * Keeps what ImageJ prints while it opens a file away from standard output and
 * standard error, when there is no window it could go to.
 */
final class QuietImageJ {

	/**
	 * @param <T> what the work gives
	 * @param value what it gave
	 * @param printed what was printed meanwhile
	 */
	record Outcome<T>(T value, String printed) {
	}

	private QuietImageJ() {
	}

	/**
	 * @param <T> what the work gives
	 * @param work calls ImageJ
	 * @return what it gave and printed
	 */
	static synchronized <T> Outcome<T> call(final Supplier<T> work) {
		if (!GraphicsEnvironment.isHeadless())
			return new Outcome<>(work.get(), "");
		final PrintStream out = System.out, err = System.err;
		final ByteArrayOutputStream printed = new ByteArrayOutputStream();
		final PrintStream catcher = new PrintStream(printed, true, StandardCharsets.UTF_8);
		System.setOut(catcher);
		System.setErr(catcher);
		try {
			return new Outcome<>(work.get(), printed.toString(StandardCharsets.UTF_8));
		} finally {
			System.setOut(out);
			System.setErr(err);
		}
	}
}
