package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.image.FrameEvidence;

/**
 * A focus that wanders: in some frames lines are wider than in others, and dimmer or not. The
 * width is that of most of the skeleton's pixels, the brightness that of a strand along the
 * best trail; both change slowly. In a movie in which they hardly do nothing is changed.
 *
 * @param widening how many times as wide as in the middle one of all frames lines are
 * @param brightness of a strand, relative to the middle one of all frames
 */
record Focus(double[] widening, double[] brightness) {

	/** Share of a line's peak in the mean over 3 x 3 pixels, which is what brightness is taken of. */
	private static double peak(final double sigma) {
		return (1 + 2 * Math.exp(-0.5 / (sigma * sigma))) / 3;
	}

	/**
	 * Frames that say how wide and bright their lines are. O(skeleton).
	 *
	 * @param frames the frames, in order of time
	 * @param sets their trails
	 * @return the same, of which is known how wide their lines are; as they were if the width
	 *         hardly changes or is not known
	 */
	static List<FrameView> known(final List<FrameView> frames, final List<CandidateSet> sets) {
		final double[] widths = frames.stream().mapToDouble(Focus::width).toArray();
		if (!changes(widths))
			return frames;
		final double[] smooth = medians(widths, TrackTuning.FOCUS_SMOOTH);
		final double usual = RobustStatistics
			.median(Arrays.stream(smooth).filter(Double::isFinite).toArray());
		final double[] bright = medians(IntStream.range(0, widths.length)
			.mapToDouble(t -> brightness(frames.get(t), sets.get(t)) / peak(smooth[t])).toArray(),
			TrackTuning.FOCUS_SMOOTH);
		final double strand = RobustStatistics
			.median(Arrays.stream(bright).filter(b -> b > 0).toArray());
		final List<FrameView> known = new ArrayList<>();
		for (int t = 0; t < smooth.length; t++)
			known.add(Double.isFinite(smooth[t]) && bright[t] > 0
				? frames.get(t).focused(smooth[t] / usual, bright[t] / strand)
				: frames.get(t));
		return known;
	}

	/** Usual standard deviation of the line across a frame's skeleton; NaN if not known. */
	private static double width(final FrameView frame) {
		if (frame.evidence().isEmpty())
			return Double.NaN;
		final FrameEvidence e = frame.evidence().get();
		final double[] widths = IntStream.range(0, e.size())
			.mapToDouble(i -> e.lineWidth(e.x(i), e.y(i))).filter(Double::isFinite).sorted()
			.toArray();
		return widths.length < TrackTuning.FOCUS_PIXELS
			? Double.NaN
			: widths[(int) (TrackTuning.FOCUS_QUANTILE * (widths.length - 1))]
				/ e.appearance().width() * e.appearance().workingSigma();
	}

	private static double brightness(final FrameView frame, final CandidateSet set) {
		return set.candidates().stream().findFirst().map(ContourBuilder::smooth)
			.filter(c -> c.size() > 1).map(c -> StrandLight.of(frame, c)).orElse(Double.NaN);
	}

	private static boolean changes(final double[] widths) {
		final double[] steady = Arrays.stream(medians(widths, TrackTuning.FOCUS_STEADY))
			.filter(Double::isFinite).sorted().toArray();
		final int tenth = steady.length / 10;
		return steady.length > TrackTuning.FOCUS_STEADY
			&& steady[steady.length - 1 - tenth] > TrackTuning.FOCUS_CHANGE * steady[tenth];
	}

	/** The median of each value and its neighbours in time, as far as they are known. */
	private static double[] medians(final double[] values, final int frames) {
		return IntStream.range(0, values.length)
			.mapToDouble(t -> RobustStatistics.median(Arrays
				.stream(values, Math.max(0, t - frames / 2),
					Math.min(values.length, t + frames / 2 + 1))
				.filter(Double::isFinite).toArray()))
			.toArray();
	}
}
