
package io.github.knotresolver.io;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Where the traces of bugs go: one file a process, made at the first bug in the folder for
 * temporary files, so that a sentence can name it and a person can attach it to a report.
 */
public final class FailureLog {

	/** The log of this process. */
	public static final FailureLog PROCESS = new FailureLog(
		Path.of(System.getProperty("java.io.tmpdir")));

	private final Path folder;
	private Path file;
	private Consumer<String> echo = trace -> {
	};

	FailureLog(final Path folder) {
		this.folder = folder;
	}

	/**
	 * From now on all traces are shown, too.
	 *
	 * @param listener told of every trace
	 */
	public synchronized void echo(final Consumer<String> listener) {
		echo = listener;
	}

	/**
	 * Keeps a failure with its whole trace.
	 *
	 * @param failure the failure
	 * @return the file that has it; empty if none can be written
	 */
	synchronized Optional<Path> keep(final Throwable failure) {
		final String trace = trace(failure);
		echo.accept(trace);
		try {
			if (file == null || !Files.exists(file))
				file = Files.createTempFile(folder, "knotresolver-", ".log");
			Files.writeString(file, heading() + trace + "\n", StandardCharsets.UTF_8,
				StandardOpenOption.APPEND);
			return Optional.of(file);
		} catch (final IOException e) {
			return Optional.empty();
		}
	}

	/**
	 * Shows a failure's trace where all traces are shown, and does not keep it.
	 *
	 * @param failure the failure
	 */
	public synchronized void show(final Throwable failure) {
		echo.accept(trace(failure));
	}

	private static String heading() {
		return ProgramVersion.NAME + " " + ProgramVersion.get() + ", Java "
			+ System.getProperty("java.version") + ", " + System.getProperty("os.name") + " "
			+ System.getProperty("os.arch") + ", " + Runtime.getRuntime().maxMemory() / (1 << 20)
			+ " MB\n";
	}

	private static String trace(final Throwable failure) {
		final StringWriter text = new StringWriter();
		failure.printStackTrace(new PrintWriter(text, true));
		return text.toString();
	}
}
