
package io.github.knotresolver.io;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;

/**
 * What a person is told when work ends early: the same on the command line, in Commands, in macros
 * and in the rows of a batch. Only a {@link UserException} speaks for itself; what nobody foresaw
 * is called a bug, and its trace goes to a log file that the sentence names.
 *
 * @param kind why the work ended
 * @param sentence the one sentence for a person
 */
public record Failure(Kind kind, String sentence) {

	/** Why work ended early. */
	public enum Kind {
		/** The user asked for it. */
		CANCELLED,
		/** Something that the user can mend. */
		USER,
		/** A file could not be written. */
		DISK,
		/** There is too little memory. */
		MEMORY,
		/** A mistake of the program. */
		BUG
	}

	private static final String ISSUES = "https://github.com/knotresolver/knotresolver-fiji/issues";

	/**
	 * @param cause what was thrown
	 * @param moreMemory how memory is given here, such as "give Java more"
	 * @return what it means
	 */
	public static Failure of(final Throwable cause, final String moreMemory) {
		return of(cause, moreMemory, FailureLog.PROCESS);
	}

	static Failure of(final Throwable cause, final String moreMemory, final FailureLog log) {
		if (cause instanceof CancelledException)
			return new Failure(Kind.CANCELLED, "Cancelled; nothing was written.");
		if (cause instanceof UserException) {
			log.show(cause);
			return new Failure(Kind.USER, oneLine(cause.getMessage()));
		}
		if (cause instanceof OutOfMemoryError) {
			log.show(cause);
			return new Failure(Kind.MEMORY,
				"There is not enough memory for this movie; " + moreMemory + ".");
		}
		if (cause instanceof IOException || cause instanceof UncheckedIOException) {
			log.show(cause);
			return new Failure(Kind.DISK,
				"The result could not be written: " + reason(cause) + ".");
		}
		return new Failure(Kind.BUG, bug(cause, log));
	}

	/** Some of Java's failures on the disk name the file and nothing else. */
	private static String reason(final Throwable cause) {
		final Throwable e = cause instanceof UncheckedIOException ? cause.getCause() : cause;
		if (e instanceof FileSystemException f && f.getReason() == null) {
			final String file = String.valueOf(f.getFile());
			if (e instanceof NoSuchFileException)
				return file + " is not there any more";
			if (e instanceof AccessDeniedException)
				return file + " may not be written; check its permissions";
			if (e instanceof FileAlreadyExistsException)
				return file + " is there already";
			if (e instanceof DirectoryNotEmptyException)
				return file + " is not empty";
		}
		final String message = e.getMessage();
		return message == null
			? "the disk refused it (" + e.getClass().getSimpleName() + ")"
			: oneLine(message).replaceFirst("\\.$", "");
	}

	private static String bug(final Throwable cause, final FailureLog log) {
		final String message = cause.getMessage() == null ? "" : ": " + oneLine(cause.getMessage());
		return "This is a bug in " + ProgramVersion.NAME + ", not a fault of yours ("
			+ cause.getClass().getSimpleName() + message + "); please report it at " + ISSUES
			+ log.keep(cause)
				.map(file -> " and attach " + file + ", which tells where it happened.")
				.orElse(", with what you did (no log could be written).");
	}

	private static String oneLine(final String message) {
		return String.valueOf(message).strip().replaceAll("\\s*\\R\\s*", " ")
			.replaceAll("\\p{Cntrl}", "\uFFFD");
	}
}
