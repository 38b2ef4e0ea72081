package io.github.knotresolver.ui.model;

import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;

/**
 * What a person should know of a result at first.
 *
 * @param filaments how many there are
 * @param right contours that are sure, of all filaments and frames
 * @param doubtful contours that should be looked at
 * @param lost frames in which a filament has no contour although it is in view
 */
public record RunOutcome(int filaments, int right, int doubtful, int lost) {

	/**
	 * @param tracks a result
	 * @return what became of its frames
	 */
	public static RunOutcome of(final Tracks tracks) {
		int right = 0, doubtful = 0, lost = 0;
		for (final var filament : tracks.filaments())
			for (final Observation o : filament.frames())
				if (o.status() == FrameStatus.UNRESOLVED || o.status() == FrameStatus.LOST)
					lost++;
				else if (o.contour().isPresent() && Doubts.isDoubtful(o))
					doubtful++;
				else if (o.contour().isPresent())
					right++;
		return new RunOutcome(tracks.filaments().size(), right, doubtful, lost);
	}

	/** @return one line, such as {@code 118 frames right, 2 doubtful, 0 lost} */
	public String line() {
		return (filaments > 1 ? filaments + " filaments: " : "") + right
			+ (right == 1 ? " frame right, " : " frames right, ") + doubtful + " doubtful, " + lost
			+ " lost";
	}
}
