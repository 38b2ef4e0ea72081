package io.github.knotresolver.track;

import java.util.Optional;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

/** What resolvers say about frames that are not simply resolved. */
final class Outcome {

	private Outcome() {
	}

	static Observation corrected(final FrameGraph frame, final Polyline contour) {
		return new Observation(frame.frame(), FrameStatus.CORRECTED, "Given by the user.",
			Optional.of(contour), frame.junctions(), 1, 0, 1);
	}

	static Observation lost(final FrameGraph frame) {
		return Observation.without(frame.frame(), FrameStatus.LOST,
			"No filament was found in this frame.");
	}

	static Observation withoutCandidates(final FrameGraph frame) {
		return Observation.without(frame.frame(), FrameStatus.UNRESOLVED,
			"The skeleton is too small to hold a contour.");
	}

	static String limitReason(final boolean limited) {
		return limited
			? "The search hit a limit: a better contour may have been missed; if it is wrong, draw the frame as a correction."
			: "";
	}
}
