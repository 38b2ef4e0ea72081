
package io.github.knotresolver.model;

/**
 * Something that the user can mend: a value, a file, a selection or a movie that cannot be used.
 * The message is for people: one sentence that names the value, what was expected and what to do.
 * The command line, Commands and the rows of a batch show it as it is.
 * <p>
 * It is the only exception that carries messages for users. An {@link IllegalArgumentException} is
 * a caller's mistake, and as every other exception that escapes it is reported as a bug, with its
 * trace.
 */
public final class UserException extends RuntimeException {

	private static final long serialVersionUID = 1;

	/**
	 * @param sentence names the value, what was expected and what to do
	 */
	public UserException(final String sentence) {
		super(sentence);
	}

	/**
	 * @param sentence names the value, what was expected and what to do
	 * @param cause the failure that it explains
	 */
	public UserException(final String sentence, final Throwable cause) {
		super(sentence, cause);
	}
}
