package io.github.knotresolver.image;

import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.geometry.RobustStatistics;

/**
 * The brightness across a movie's lines: the median over all pixels of the skeletons of a
 * frame, then over frames. What lies beside a line here and there has no part in it.
 */
public final class CrossProfile {
	private static final int STEPS = 64;

	/** The maximum is looked for within a standard deviation of the middle. */
	private static final int MIDDLE = STEPS / 8;

	/** The outermost samples are the background. */
	private static final int OUTER = STEPS / 8;

	private CrossProfile() {
	}

	/**
	 * @param ridges a frame
	 * @param places of its skeleton's pixels, row by row
	 * @return brightness across the line; empty if there are too few pixels
	 */
	public static double[] of(final Ridges ridges, final int[] places) {
		if (places.length <= ImageTuning.FEWEST_CREST)
			return new double[0];
		final double[] profile = new double[STEPS + 1];
		final double[] values = new double[places.length];
		for (int k = 0; k <= STEPS; k++) {
			final double d = offset(k) * ridges.appearance().workingSigma();
			for (int i = 0; i < places.length; i++) {
				final double angle = ridges.angle(places[i]);
				values[i] = Pixels.between(ridges.clean(), ridges.width(),
					places[i] % ridges.width() - d * Math.sin(angle),
					places[i] / ridges.width() + d * Math.cos(angle));
			}
			profile[k] = RobustStatistics.median(values);
		}
		return profile;
	}

	/**
	 * @param profiles of several frames, of the same appearance; empty ones do not count
	 * @return the full width at half maximum of their median, in standard deviations of
	 *         the line as it was taken to be; NaN if there is none
	 */
	public static double width(final List<double[]> profiles) {
		final List<double[]> known = profiles.stream().filter(p -> p.length > 0).toList();
		if (known.isEmpty())
			return Double.NaN;
		final double[] profile = new double[STEPS + 1];
		for (int k = 0; k <= STEPS; k++) {
			final int at = k;
			profile[k] = RobustStatistics.median(known.stream().mapToDouble(p -> p[at]).toArray());
		}
		return width(profile);
	}

	private static double width(final double[] profile) {
		int top = STEPS / 2 - MIDDLE;
		for (int k = top; k <= STEPS / 2 + MIDDLE; k++)
			if (profile[k] > profile[top])
				top = k;
		final double background = (RobustStatistics.median(Arrays.copyOf(profile, OUTER))
			+ RobustStatistics.median(Arrays.copyOfRange(profile, STEPS + 1 - OUTER, STEPS + 1)))
			/ 2;
		final double half = (profile[top] + background) / 2;
		return side(profile, top, half, 1) + side(profile, top, half, -1);
	}

	/** How far it is from the top to half the height, on one side. */
	private static double side(final double[] profile, final int top, final double half,
		final int step) {
		int k = top;
		while (k > 0 && k < STEPS && profile[k] > half)
			k += step;
		final double before = profile[k - step], rest = k == top || before == profile[k]
			? 0
			: (half - profile[k]) / (before - profile[k]);
		return (Math.abs(k - top) - rest) * (offset(1) - offset(0));
	}

	private static double offset(final int k) {
		return ImageTuning.PROFILE_REACH * (2.0 * k / STEPS - 1);
	}
}
