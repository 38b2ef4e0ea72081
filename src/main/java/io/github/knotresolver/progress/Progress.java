package io.github.knotresolver.progress;

import java.util.List;

import io.github.knotresolver.geometry.Polyline;

/**
 * Where long work says how far it is, and asks whether it should stop. ImageJ,
 * the command line and tests are listeners of the same kind. Implementations
 * must be safe to call from several threads.
 */
public interface Progress {

	/** Listens to nothing and never cancels. */
	Progress NONE = new Progress() {

		@Override
		public void report(final String stage, final double fraction) {
		}

		@Override
		public boolean isCancelled() {
			return false;
		}
	};

	/**
	 * Called every now and then.
	 *
	 * @param stage what is being done, in a few words
	 * @param fraction how much of this stage is done, 0..1
	 */
	void report(String stage, double fraction);

	/**
	 * Called when something is found out that a user should know while the work goes on. The
	 * result says it again; whoever shows only results need not listen.
	 *
	 * @param sentence one sentence
	 */
	default void note(final String sentence) {
	}

	/**
	 * Called when contours of a frame are found, long before it is decided which are right. Whoever
	 * does not draw them need not listen.
	 *
	 * @param frame 1-based number of the frame
	 * @param contours in pixels, in place of those that were told of this frame before
	 */
	default void sighted(final int frame, final List<Polyline> contours) {
	}

	/** @return listens to nothing, but cancels when this does: for one of many parts of a work */
	default Progress silent() {
		final Progress whole = this;
		return new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
			}

			@Override
			public boolean isCancelled() {
				return whole.isCancelled();
			}
		};
	}

	/** @return whether the user asked to stop */
	boolean isCancelled();

	/**
	 * Called in every inner loop that may take longer than a blink.
	 *
	 * @throws CancelledException if the user asked to stop
	 */
	default void checkCancelled() {
		if (isCancelled())
			throw new CancelledException();
	}
}
