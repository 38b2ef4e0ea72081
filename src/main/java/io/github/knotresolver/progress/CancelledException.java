
package io.github.knotresolver.progress;

/** The user asked long work to stop. Not an error: nothing is reported. */
public final class CancelledException extends RuntimeException {

	/** The work of this thread stops. */
	public CancelledException() {
		super("Cancelled.");
	}
}
