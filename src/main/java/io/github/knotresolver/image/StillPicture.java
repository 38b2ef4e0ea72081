package io.github.knotresolver.image;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.RobustStatistics;

/**
 * What stays where it is while lines move over it: how bright every pixel is when no line lies
 * on it. Light only adds, so it is what the darkest frames of a pixel show; their noise is
 * known from how neighbouring frames differ.
 */
public final class StillPicture {

	/** Of normal noise a tenth is so many standard deviations below the middle. */
	private static final double BELOW = 1.2816;

	/** So many frames around that rank, to both sides, are averaged. */
	private static final int RANKS = 2;

	private StillPicture() {
	}

	/**
	 * @param frames how many there are
	 * @param most at least two
	 * @return indices of so many of them, or of all, spread evenly from the first to the last
	 */
	public static int[] looks(final int frames, final int most) {
		final int count = Math.min(most, frames);
		return IntStream.range(0, count).map(k -> (int) ((long) k * (frames - 1) / (count - 1)))
			.toArray();
	}

	/**
	 * O(n log n) for n frames, for each pixel.
	 *
	 * @param frames pixels of the frames in order of time, at least two, lines bright; without
	 *          a value (NaN) nowhere
	 * @return the still picture
	 */
	public static float[] of(final List<float[]> frames) {
		final float[] still = new float[frames.get(0).length];
		final double[] values = new double[frames.size()], steps = new double[values.length - 1];
		for (int i = 0; i < still.length; i++) {
			for (int t = 0; t < values.length; t++)
				values[t] = frames.get(t)[i];
			for (int t = 0; t < steps.length; t++)
				steps[t] = Math.abs(values[t + 1] - values[t]);
			Arrays.sort(steps);
			Arrays.sort(values);
			final double noise = RobustStatistics.MAD_TO_SD * middle(steps) / Math.sqrt(2);
			still[i] = (float) (darkest(values) + BELOW * noise);
		}
		return still;
	}

	private static double middle(final double[] sorted) {
		return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
	}

	private static double darkest(final double[] sorted) {
		final int rank = (int) (ImageTuning.STILL_FREE * sorted.length);
		final int from = Math.max(0, rank - RANKS), to = Math.min(sorted.length, rank + RANKS + 1);
		return Arrays.stream(sorted, from, to).average().orElseThrow();
	}
}
