package io.github.knotresolver.fit;

import java.util.Arrays;

/**
 * How a filament's brightness fades over the movie: exponentially, as fluorophores
 * bleach. The rate is the median of the slopes between all pairs of frames (Theil and
 * Sen, doi:10.1080/01621459.1968.10480934), so that frames in which something else was
 * measured do not matter.
 *
 * @param rate of fading per frame; negative if the filament brightens; 0 if its brightness
 *          does not change noticeably
 */
public record Bleaching(double rate) {

	/** A filament that neither fades nor brightens. */
	public static final Bleaching NONE = new Bleaching(0);

	/** A change over the whole movie below this (relative) is not corrected. */
	private static final double NOTICEABLE = 0.1;

	/**
	 * Learns the rate. O(frames²).
	 *
	 * @param brightness of the filament in each frame, above the background; NaN or not
	 *          positive where it is not known
	 * @return the fading
	 */
	public static Bleaching learn(final double[] brightness) {
		final int n = brightness.length;
		final double[] slopes = new double[n * (n - 1) / 2];
		int count = 0;
		for (int i = 0; i < n; i++)
			for (int j = i + 1; j < n; j++)
				if (brightness[i] > 0 && brightness[j] > 0)
					slopes[count++] = Math.log(brightness[j] / brightness[i]) / (j - i);
		if (count == 0)
			return NONE;
		Arrays.sort(slopes, 0, count);
		final double rate = -slopes[count / 2];
		return Math.abs(rate) * (n - 1) < NOTICEABLE ? NONE : new Bleaching(rate);
	}

	/**
	 * @param frame 0-based index of the frame
	 * @return the brightness of that frame's filament relative to the first frame's
	 */
	public double factor(final int frame) {
		return Math.exp(-rate * frame);
	}
}
