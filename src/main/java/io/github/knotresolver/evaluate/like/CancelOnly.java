package io.github.knotresolver.evaluate.like;

import io.github.knotresolver.progress.Progress;

/** For a part of longer work: may be cancelled, but says nothing. */
record CancelOnly(Progress whole) implements Progress {

	@Override
	public void report(final String stage, final double fraction) {
	}

	@Override
	public boolean isCancelled() {
		return whole.isCancelled();
	}
}
