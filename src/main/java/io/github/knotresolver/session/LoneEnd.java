package io.github.knotresolver.session;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.track.FixedEndFinder;
import io.github.knotresolver.track.FrameView;

/**
 * A quick guess from a few frames whether there is one filament, clamped at one end: enough to draw a
 * preview, while the run itself looks at the whole movie.
 */
final class LoneEnd {

	private LoneEnd() {
	}

	/** @return where the filament is clamped, in the frames' pixels; empty if it does not look like that */
	static Optional<Point> of(final List<FrameView> frames, final Progress progress) {
		final long single = frames.stream().filter(f -> EvidenceNotes.objects(f) == 1).count();
		return single == 0 || single < SessionTuning.PREVIEW_SINGLE * frames.size()
			? Optional.empty()
			: new FixedEndFinder(frames, progress).find().filter(end -> isInPlace(end, frames));
	}

	private static boolean isInPlace(final Point end, final List<FrameView> frames) {
		return frames.stream()
			.filter(f -> f.graph().freeEnds().stream()
				.anyMatch(n -> n.position().distanceTo(end) <= SessionTuning.PREVIEW_END))
			.count() >= SessionTuning.PREVIEW_CLAMPED * frames.size();
	}
}
