
package io.github.knotresolver.track;

import java.util.List;

import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Observation;

/**
 * Whether a filament's length is a guess: it is not evenly bright, and its tip lies on itself in
 * nearly all frames, so that what is brighter there may be a brighter part of it or two strands;
 * or the light of its ends does not say where it ends.
 */
final class GuessedLength {

	private static final String WHY = "Doubtful: the filament is not evenly bright and its tip lies on it in nearly all frames, so its length is a guess.";

	private static final String WHY_ENDS = "Doubtful: the light does not say where the filament ends: it fades out, or something else lies there; so its length is a guess.";

	private GuessedLength() {
	}

	/**
	 * Takes confidence off all frames if the length is a guess. O(frames * length).
	 *
	 * @param frames of one filament, in order of time
	 * @param estimate what the movie says about the filament
	 * @return the same contours, none of which is believed if their length is a guess
	 */
	static List<Observation> doubted(final List<Observation> frames,
		final FilamentEstimate estimate) {
		if (estimate.guessed())
			return frames.stream().map(o -> o.atMost(TrackTuning.GUESSED, WHY_ENDS)).toList();
		final LineModel model = estimate.model();
		if (model.isEven())
			return frames;
		final List<Polyline> contours = frames.stream().flatMap(f -> f.contour().stream()).toList();
		final long hidden = contours.stream().filter(c -> isHidden(c, model)).count();
		return hidden <= TrackTuning.NEARLY_ALL * contours.size()
			? frames
			: frames.stream().map(o -> o.atMost(TrackTuning.GUESSED, WHY)).toList();
	}

	/** Whether a frame shows the tip, and it does not lie on the filament or close beside it. */
	static boolean isTipFree(final Observation frame, final LineModel model) {
		return frame.visible() == 1 && frame.contour().filter(c -> !isHidden(c, model)).isPresent();
	}

	private static boolean isHidden(final Polyline contour, final LineModel model) {
		final double width = LineAppearance.FULL_WIDTH * model.sigma();
		final double before = contour.length() - TrackTuning.TAIL * width;
		return before > 0 && contour.head(before).distanceTo(contour.last()) < width;
	}
}
