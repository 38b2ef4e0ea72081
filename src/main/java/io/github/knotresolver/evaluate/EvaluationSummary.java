package io.github.knotresolver.evaluate;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;

import io.github.knotresolver.evaluate.Evaluation.FrameScore;

/**
 * The figures of a whole movie. Percentages, means and medians of no frame at
 * all are NaN.
 */
public final class EvaluationSummary {

	private final List<FrameScore> all, present, crossing, simple;
	private final int extraFrames;

	EvaluationSummary(final Evaluation evaluation) {
		all = evaluation.frames();
		present = select(all, FrameScore::present);
		crossing = select(all, f -> f.crossings() > 0);
		simple = select(all, f -> f.crossings() == 0);
		extraFrames = evaluation.extraFrames();
	}

	/** @return frames of the truth */
	public int frames() {
		return all.size();
	}

	/** @return of them, those with a contour */
	public int framesPresent() {
		return present.size();
	}

	/** @return of them, those in which the true contour crosses itself */
	public int framesWithCrossings() {
		return crossing.size();
	}

	/** @return frames of the result that the truth does not have */
	public int extraResultFrames() {
		return extraFrames;
	}

	/** @return mean Dice index of all frames */
	public double meanDice() {
		return mean(all, CurveScore::dice);
	}

	/** @return the same of the frames with crossings */
	public double meanDiceCrossingFrames() {
		return mean(crossing, CurveScore::dice);
	}

	/** @return median Frechet distance of all frames in pixels; missing frames are infinitely far */
	public double medianFrechet() {
		return median(all, CurveScore::frechet);
	}

	/** @return the same of the frames with a contour */
	public double medianFrechetPresent() {
		return median(present, CurveScore::frechet);
	}

	/** @return mean of the frames' errors in pixels, frames with a contour */
	public double meanError() {
		return mean(present, CurveScore::error);
	}

	/** @return mean of the frames' misses in pixels, frames with a contour */
	public double meanMiss() {
		return mean(present, CurveScore::miss);
	}

	/** @return median magnitude of the length's error in percent, frames with a contour */
	public double medianAbsoluteLengthError() {
		return median(present, s -> Math.abs(s.lengthError()));
	}

	/** @return frames with a Frechet distance below 5 px, in percent */
	public double percentResolved() {
		return percentResolved(all);
	}

	/** @return the same of the frames with crossings */
	public double percentResolvedCrossingFrames() {
		return percentResolved(crossing);
	}

	/** @return the same of the frames without */
	public double percentResolvedSimpleFrames() {
		return percentResolved(simple);
	}

	/** @return how many contours are right but for their direction */
	public int framesFlipped() {
		return select(present, f -> f.score().isFlipped()).size();
	}

	/** @return the first frame that is not resolved */
	public OptionalInt firstUnresolvedFrame() {
		return all.stream().filter(f -> !f.score().isResolved()).mapToInt(FrameScore::frame)
			.findFirst();
	}

	private static List<FrameScore> select(final List<FrameScore> frames,
		final Predicate<FrameScore> which) {
		return frames.stream().filter(which).toList();
	}

	private static double percentResolved(final List<FrameScore> frames) {
		return mean(frames, s -> s.isResolved() ? 100 : 0);
	}

	private static double mean(final List<FrameScore> frames,
		final ToDoubleFunction<CurveScore> figure) {
		return frames.stream().map(FrameScore::score).mapToDouble(figure).average()
			.orElse(Double.NaN);
	}

	private static double median(final List<FrameScore> frames,
		final ToDoubleFunction<CurveScore> figure) {
		final double[] v = frames.stream().map(FrameScore::score).mapToDouble(figure).toArray();
		if (v.length == 0)
			return Double.NaN;
		Arrays.sort(v);
		final double low = v[(v.length - 1) / 2], high = v[v.length / 2];
		return low == high ? low : (low + high) / 2;
	}
}
