package io.github.knotresolver.image;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

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
		return median(profiles).map(p -> width(p, 0.5)).orElse(Double.NaN);
	}

	/**
	 * How blunt lines are. That of a Gaussian is 0.46; a line whose light does not add up, or that was
	 * cut off, has steeper sides.
	 *
	 * @param profiles of several frames, of the same appearance; empty ones do not count
	 * @return the full width at three quarters of the height of their median, by that at a quarter,
	 *         0..1; NaN if there is none
	 */
	public static double bluntness(final List<double[]> profiles) {
		return median(profiles).map(p -> width(p, 0.75) / width(p, 0.25)).orElse(Double.NaN);
	}

	private static Optional<double[]> median(final List<double[]> profiles) {
		final List<double[]> known = profiles.stream().filter(p -> p.length > 0).toList();
		if (known.isEmpty())
			return Optional.empty();
		final double[] profile = new double[STEPS + 1];
		for (int k = 0; k <= STEPS; k++) {
			final int at = k;
			profile[k] = RobustStatistics.median(known.stream().mapToDouble(p -> p[at]).toArray());
		}
		return Optional.of(profile);
	}

	/** The full width at a share of the height. */
	private static double width(final double[] profile, final double share) {
		int top = STEPS / 2 - MIDDLE;
		for (int k = top; k <= STEPS / 2 + MIDDLE; k++)
			if (profile[k] > profile[top])
				top = k;
		final double background = (RobustStatistics.median(Arrays.copyOf(profile, OUTER))
			+ RobustStatistics.median(Arrays.copyOfRange(profile, STEPS + 1 - OUTER, STEPS + 1)))
			/ 2;
		final double height = background + share * (profile[top] - background);
		return side(profile, top, height, 1) + side(profile, top, height, -1);
	}

	/** How far it is from the top to a height, on one side. */
	private static double side(final double[] profile, final int top, final double height,
		final int step) {
		int k = top;
		while (k > 0 && k < STEPS && profile[k] > height)
			k += step;
		final double before = profile[k - step], rest = k == top || before == profile[k]
			? 0
			: (height - profile[k]) / (before - profile[k]);
		return (Math.abs(k - top) - rest) * (offset(1) - offset(0));
	}

	private static double offset(final int k) {
		return ImageTuning.PROFILE_REACH * (2.0 * k / STEPS - 1);
	}
}
