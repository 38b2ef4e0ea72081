package io.github.knotresolver.evaluate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * A whole result against the truth: one row for every frame of the truth.
 *
 * @param frames the scores, by frame
 * @param extraFrames frames of the result that the truth does not have
 * @param positionErrors minimal distances of all points of the result, a point
 *          every pixel, to the true curves, in pixels
 */
public record Evaluation(List<FrameScore> frames, int extraFrames, double[] positionErrors) {

	public Evaluation {
		frames = List.copyOf(frames);
		positionErrors = positionErrors.clone();
	}

	/**
	 * Scores a result.
	 *
	 * @param truth the true contours in pixels by 1-based frame, each longer than 0
	 * @param result the contours to judge, likewise; contours without length count
	 *          as missing
	 * @param progress told after every frame; may cancel
	 * @return the evaluation
	 * @throws UserException if there is no truth, or a true contour has
	 *           no length
	 */
	public static Evaluation of(final SortedMap<Integer, Polyline> truth,
		final SortedMap<Integer, Polyline> result, final Progress progress) {
		if (truth.isEmpty())
			throw new UserException(
				"truth has no frame to compare with; give contours, such as the contours.csv that 'simulate' writes.");
		final List<FrameScore> frames = new ArrayList<>();
		final List<double[]> errors = new ArrayList<>();
		for (final Map.Entry<Integer, Polyline> entry : truth.entrySet()) {
			progress.checkCancelled();
			final Polyline contour = result.get(entry.getKey());
			frames.add(score(entry.getKey(), entry.getValue(), contour));
			if (isPresent(contour))
				errors.add(CurveScore.positionErrors(entry.getValue(), contour));
			progress.report("Comparing", (double) frames.size() / truth.size());
		}
		final int extra = (int) result.keySet().stream().filter(f -> !truth.containsKey(f)).count();
		return new Evaluation(frames, extra,
			errors.stream().flatMapToDouble(Arrays::stream).toArray());
	}

	private static FrameScore score(final int frame, final Polyline truth, final Polyline contour) {
		if (!(truth.length() > 0))
			throw new UserException("truth has a contour without length in frame " + frame
				+ "; give it two points or more.");
		final int crossings = Crossings.of(truth.resampled(1)).size();
		final boolean present = isPresent(contour);
		return new FrameScore(frame, present, crossings,
			present ? CurveScore.of(truth, contour) : CurveScore.MISSING);
	}

	private static boolean isPresent(final Polyline contour) {
		return contour != null && contour.length() > 0;
	}

	@Override
	public double[] positionErrors() {
		return positionErrors.clone();
	}

	/** @return the figures of the whole movie */
	public EvaluationSummary summary() {
		return new EvaluationSummary(this);
	}

	/**
	 * One frame of the truth and what the result made of it.
	 *
	 * @param frame 1-based
	 * @param present whether the result has a contour there
	 * @param crossings proper self-intersections of the true contour
	 * @param score how near it is; {@link CurveScore#MISSING} without a contour
	 */
	public record FrameScore(int frame, boolean present, int crossings, CurveScore score) {
	}
}
