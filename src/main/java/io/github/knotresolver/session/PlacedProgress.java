package io.github.knotresolver.session;

import java.util.List;
import java.util.function.UnaryOperator;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;

/**
 * Progress of work in other pixels than those of the listener.
 *
 * @param whole the listener
 * @param out brings a contour into the listener's pixels
 */
record PlacedProgress(Progress whole, UnaryOperator<Polyline> out) implements Progress {

	@Override
	public void report(final String stage, final double fraction) {
		whole.report(stage, fraction);
	}

	@Override
	public void note(final String sentence) {
		whole.note(sentence);
	}

	@Override
	public void sighted(final int frame, final List<Polyline> contours) {
		whole.sighted(frame, contours.stream().map(out).toList());
	}

	@Override
	public boolean isCancelled() {
		return whole.isCancelled();
	}
}
