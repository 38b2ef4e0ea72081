package io.github.knotresolver.fit;

import java.util.Arrays;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.RobustLine;
import io.github.knotresolver.geometry.RobustStatistics;

/**
 * How a filament's brightness fades over the movie: exponentially, as fluorophores
 * bleach. The rate is the median of the logarithm's slopes, so that frames in which
 * something else was measured do not matter.
 *
 * @param rate of fading per frame; negative if the filament brightens; 0 if its brightness
 *          does not change noticeably
 */
public record Bleaching(double rate) {

	/** A filament that neither fades nor brightens. */
	public static final Bleaching NONE = new Bleaching(0);

	/**
	 * Learns the rate. Cost: that of a {@link RobustLine}'s slopes.
	 *
	 * @param brightness of the filament in each frame, above the background; NaN or not
	 *          positive where it is not known
	 * @return the fading
	 */
	public static Bleaching learn(final double[] brightness) {
		final int[] known = IntStream.range(0, brightness.length).filter(t -> brightness[t] > 0)
			.toArray();
		final double[] slopes = RobustLine.slopes(Arrays.stream(known).asDoubleStream().toArray(),
			Arrays.stream(known).mapToDouble(t -> brightness[t]).toArray(),
			(a, b) -> Math.log(b / a));
		final double rate = -RobustStatistics.upperMedian(slopes, 0);
		return Math.abs(rate) * (brightness.length - 1) < FitTuning.BLEACHED
			? NONE
			: new Bleaching(rate);
	}

	/**
	 * @param frame 0-based index of the frame
	 * @return the brightness of that frame's filament relative to the first frame's
	 */
	public double factor(final int frame) {
		return Math.exp(-rate * frame);
	}
}
