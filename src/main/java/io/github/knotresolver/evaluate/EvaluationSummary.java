package io.github.knotresolver.evaluate;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;

/**
 * The figures of a whole movie. Percentages, means and medians of no frame at
 * all are NaN.
 *
 * @param frames frames of the truth
 * @param framesPresent of them, those with a contour
 * @param framesWithCrossings of them, those in which the true contour crosses
 *          itself
 * @param extraResultFrames frames of the result that the truth does not have
 * @param meanDice mean Dice index of all frames
 * @param meanDiceCrossingFrames the same of the frames with crossings
 * @param medianFrechet median Frechet distance of all frames in pixels; missing
 *          frames are infinitely far
 * @param medianFrechetPresent the same of the frames with a contour
 * @param meanError mean of the frames' errors in pixels, frames with a contour
 * @param meanMiss mean of the frames' misses in pixels, frames with a contour
 * @param medianAbsoluteLengthError median of the magnitude in percent, frames
 *          with a contour
 * @param percentResolved frames with a Frechet distance below 5 px
 * @param percentResolvedCrossingFrames the same of the frames with crossings
 * @param percentResolvedSimpleFrames the same of the frames without
 * @param framesFlipped contours that are right but for their direction
 * @param firstUnresolvedFrame the first frame that is not resolved
 */
public record EvaluationSummary(int frames, int framesPresent, int framesWithCrossings,
	int extraResultFrames, double meanDice, double meanDiceCrossingFrames, double medianFrechet,
	double medianFrechetPresent, double meanError, double meanMiss,
	double medianAbsoluteLengthError, double percentResolved, double percentResolvedCrossingFrames,
	double percentResolvedSimpleFrames, int framesFlipped, OptionalInt firstUnresolvedFrame) {

	static EvaluationSummary of(final Evaluation evaluation) {
		final List<FrameScore> all = evaluation.frames();
		final List<FrameScore> present = select(all, FrameScore::present);
		final List<FrameScore> crossing = select(all, f -> f.crossings() > 0);
		final List<FrameScore> simple = select(all, f -> f.crossings() == 0);
		return new EvaluationSummary(all.size(), present.size(), crossing.size(),
			evaluation.extraFrames(), mean(all, CurveScore::dice), mean(crossing, CurveScore::dice),
			median(all, CurveScore::frechet), median(present, CurveScore::frechet),
			mean(present, CurveScore::error), mean(present, CurveScore::miss),
			median(present, s -> Math.abs(s.lengthError())), percentResolved(all),
			percentResolved(crossing), percentResolved(simple),
			select(present, f -> f.score().isFlipped()).size(), all.stream()
				.filter(f -> !f.score().isResolved()).mapToInt(FrameScore::frame).findFirst());
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
