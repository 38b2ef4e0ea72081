package io.github.knotresolver.evaluate;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;

import io.github.knotresolver.evaluate.Evaluation.FrameScore;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * A result with several filaments against the truth. Each true filament is given
 * at most one of the result, one to one, so that the most frames agree: discrete
 * Frechet distance below 5 px, in one direction of the result's filament for the
 * whole movie. A filament-frame is a true filament in a frame.
 *
 * @param filaments the true filaments, each with what it was given
 * @param resultFilaments number of filaments of the result
 * @param frames number of filament-frames
 * @param crossingFrames those in which the filament crosses itself or another one
 * @param resolved filament-frames in which what was given is right
 * @param resolvedCrossing the same of {@code crossingFrames}
 * @param found filament-frames in which any filament of the result is right, whatever
 *          its identity and direction
 * @param switches changes, from frame to frame, of which filament of the result
 *          agrees with a true one
 * @param shown contours of the result in frames of the truth and others
 * @param wrong those of them that agree with no true filament
 * @param silent those of {@code wrong} with a confidence above 0.9; -1 if the result
 *          does not tell its confidence
 */
public record SceneEvaluation(List<FilamentScore> filaments, int resultFilaments, int frames,
	int crossingFrames, int resolved, int resolvedCrossing, int found, int switches, int shown,
	int wrong, int silent) {

	public SceneEvaluation {
		filaments = List.copyOf(filaments);
	}

	/**
	 * Scores a result. O(n · m) comparisons a frame for n true and m resulting filaments.
	 *
	 * @param truth the true contours in pixels, by filament and 1-based frame
	 * @param result the contours to judge, likewise
	 * @param confidence of the result, by filament and frame; may be empty
	 * @param progress told after every frame; may cancel
	 * @return the evaluation
	 * @throws UserException if there is no truth, or a true contour has no length
	 */
	public static SceneEvaluation of(final SortedMap<Integer, SortedMap<Integer, Polyline>> truth,
		final SortedMap<Integer, SortedMap<Integer, Polyline>> result,
		final Map<Integer, Map<Integer, Double>> confidence, final Progress progress) {
		if (truth.isEmpty())
			throw new UserException(
				"truth has no frame to compare with; give contours, such as the contours.csv that 'simulate' writes.");
		return new SceneScorer(truth, result, confidence).score(progress);
	}

	/** @return whether every true filament that was given one runs the right way, in percent */
	public double percentRightWay() {
		return percent(filaments.stream().filter(f -> f.isGiven() && !f.reversed()).count(),
			filaments.stream().filter(FilamentScore::isGiven).count());
	}

	/** @return resolved filament-frames in percent; NaN if there are none at all */
	public double percentResolved() {
		return percent(resolved, frames);
	}

	/** @return the same of those in which filaments cross */
	public double percentResolvedCrossing() {
		return percent(resolvedCrossing, crossingFrames);
	}

	/** @return found filament-frames in percent */
	public double percentFound() {
		return percent(found, frames);
	}

	/** @return contours that agree with no true filament, in percent of all of the result */
	public double percentFalse() {
		return percent(wrong, shown);
	}

	/** @return wrong contours that claim to be sure, in percent of all; NaN if it is not known */
	public double percentSilent() {
		return silent < 0 ? Double.NaN : percent(silent, shown);
	}

	/** @return mean position error of the resolved filament-frames in pixels; NaN if none is */
	public double meanErrorResolved() {
		return filaments.stream().flatMap(f -> f.evaluation().frames().stream())
			.map(FrameScore::score).filter(CurveScore::isResolved).mapToDouble(CurveScore::error)
			.average().orElse(Double.NaN);
	}

	/** @return position errors of all true filaments with what they were given, in pixels */
	public double[] positionErrors() {
		return filaments.stream()
			.flatMapToDouble(f -> Arrays.stream(f.evaluation().positionErrors())).toArray();
	}

	private static double percent(final long part, final long whole) {
		return whole == 0 ? Double.NaN : 100.0 * part / whole;
	}

	/**
	 * A true filament and the one of the result that it was given.
	 *
	 * @param filament number of the true filament
	 * @param result number of the result's filament; empty if it was given none
	 * @param reversed whether the result runs from its last end to its first
	 * @param evaluation frame by frame, the result turned round if it is reversed
	 */
	public record FilamentScore(int filament, OptionalInt result, boolean reversed,
		Evaluation evaluation) {

		/** @return whether there is a filament of the result for it */
		public boolean isGiven() {
			return result.isPresent();
		}
	}
}
