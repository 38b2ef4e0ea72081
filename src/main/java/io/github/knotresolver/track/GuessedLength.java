
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Observation;

/**
 * Whether a filament's length is a guess: it is not evenly bright, or clipped, or its frames are few,
 * and its tip lies on itself in nearly all of them, so that one strand there cannot be told from two;
 * or the light of its ends does not say where it ends.
 */
final class GuessedLength {

	private static final String WHY = "Doubtful: the filament is not evenly bright and its tip lies on it in nearly all frames, so its length is a guess.";

	private static final String WHY_CLIPPED = "Doubtful: the picture is clipped, so that two strands are no brighter than one, and the filament's tip lies on it in nearly all frames; so its length is a guess.";

	private static final String WHY_FEW = "Doubtful: the movie is short and the filament's tip lies on it in nearly all frames, so its length is a guess.";

	private static final String WHY_ENDS = "Doubtful: the light does not say where the filament ends: it fades out, or something else lies there; so its length is a guess.";

	private static final String WHY_BROKEN = "Doubtful: the filament seems to have broken while its tip lay on it, and no frame shows its end; so its length is a guess.";

	private GuessedLength() {
	}

	/**
	 * Takes confidence off all frames if the length is a guess. O(frames * length).
	 *
	 * @param frames of one filament, in order of time
	 * @param estimate what the movie says about the filament
	 * @param clipped whether light is missing where strands lie on each other
	 * @return the same contours, none of which is believed if their length is a guess
	 */
	static List<Observation> doubted(final List<Observation> frames,
		final FilamentEstimate estimate, final boolean clipped) {
		if (estimate.guessed())
			return frames.stream().map(o -> o.atMost(TrackTuning.GUESSED, WHY_ENDS)).toList();
		final LineModel model = estimate.model();
		final List<Polyline> contours = frames.stream().flatMap(f -> f.contour().stream()).toList();
		final boolean few = contours.size() < TrackTuning.HIDDEN_FEW;
		if (model.isEven() && !clipped && !few)
			return frames;
		final double apart = few ? TrackTuning.TIP_APART * width(model) : width(model);
		final long hidden = contours.stream().filter(c -> isHidden(c, apart)).count();
		final String why = few ? WHY_FEW : clipped ? WHY_CLIPPED : WHY;
		return hidden <= TrackTuning.NEARLY_ALL * contours.size()
			? frames
			: frames.stream().map(o -> o.atMost(TrackTuning.GUESSED, why)).toList();
	}

	/**
	 * Takes confidence off the frames before or after a break of which hardly one shows the tip free: a
	 * dim tip that comes to lie on the filament looks as if it were gone. O(frames * length).
	 *
	 * @param frames of one filament, in order of time
	 * @param course its length
	 * @param model what its line looks like
	 * @return the same contours, none of which is believed on a side of a break that is not seen
	 */
	static List<Observation> doubtedAtBreak(final List<Observation> frames,
		final LengthCourse course, final LineModel model) {
		if (course.at() == 0)
			return frames;
		final List<Observation> doubted = new ArrayList<>(
			ifHidden(frames.subList(0, course.at()), model));
		doubted.addAll(ifHidden(frames.subList(course.at(), frames.size()), model));
		return doubted;
	}

	private static List<Observation> ifHidden(final List<Observation> side, final LineModel model) {
		return side.stream().filter(f -> isTipFree(f, TrackTuning.TIP_APART * width(model)))
			.count() >= TrackTuning.BREAK_SHOWN
				? side
				: side.stream().map(o -> o.atMost(TrackTuning.GUESSED, WHY_BROKEN)).toList();
	}

	/** Whether a frame shows the tip, and it does not lie on the filament or close beside it. */
	static boolean isTipFree(final Observation frame, final LineModel model) {
		return isTipFree(frame, width(model));
	}

	private static boolean isTipFree(final Observation frame, final double apart) {
		return frame.visible() == 1 && frame.contour().filter(c -> !isHidden(c, apart)).isPresent();
	}

	private static boolean isHidden(final Polyline contour, final double width) {
		final double before = contour.length() - TrackTuning.TAIL * width;
		return before > 0 && contour.head(before).distanceTo(contour.last()) < width;
	}

	private static double width(final LineModel model) {
		return LineAppearance.FULL_WIDTH * model.sigma();
	}
}
