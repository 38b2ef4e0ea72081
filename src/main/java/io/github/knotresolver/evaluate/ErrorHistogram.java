package io.github.knotresolver.evaluate;

import java.util.Arrays;
import java.util.Optional;

import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.apache.commons.math3.exception.MathIllegalStateException;
import org.apache.commons.math3.fitting.GaussianCurveFitter;
import org.apache.commons.math3.fitting.WeightedObservedPoints;

/**
 * How position errors are distributed: a probability density in bins of equal
 * width from 0, and the Gaussian that fits it best, as the published evaluation
 * reports it.
 *
 * @param binWidth width of a bin in pixels
 * @param density probability density of every bin in 1/px; bin i holds
 *          {@code i * binWidth} up to {@code (i + 1) * binWidth}
 * @param gaussian the fitted Gaussian; empty if there are fewer than three bins
 *          or no fit is found
 */
public record ErrorHistogram(double binWidth, double[] density, Optional<Gaussian> gaussian) {

	/** Width of a bin that shows sub-pixel errors, in pixels. */
	public static final double FINE_BIN = 0.1;

	private static final int MOST_ITERATIONS = 1000;
	private static final int MOST_BINS = 10_000;

	/**
	 * A Gaussian density.
	 *
	 * @param mean in pixels
	 * @param sigma in pixels, above 0
	 * @param height its largest density in 1/px
	 */
	public record Gaussian(double mean, double sigma, double height) {

		/**
		 * @param error a distance in pixels
		 * @return the density there in 1/px
		 */
		public double at(final double error) {
			final double z = (error - mean) / sigma;
			return height * Math.exp(-z * z / 2);
		}
	}

	public ErrorHistogram {
		density = density.clone();
	}

	/**
	 * Sorts errors into bins. Errors beyond ten thousand bins count in the last.
	 *
	 * @param errors distances in pixels, at least 0
	 * @param binWidth width of a bin in pixels, above 0; 0.1 shows sub-pixel errors
	 * @return the histogram
	 */
	public static ErrorHistogram of(final double[] errors, final double binWidth) {
		if (!(binWidth > 0))
			throw new IllegalArgumentException(
				"The width of a bin must be above 0 pixels, but is " + binWidth + ".");
		final double largest = Arrays.stream(errors).max().orElse(0);
		final double[] density = new double[bin(largest, binWidth) + 1];
		for (final double error : errors)
			density[bin(error, binWidth)] += 1 / (errors.length * binWidth);
		return new ErrorHistogram(binWidth, density, fit(density, binWidth));
	}

	private static int bin(final double error, final double binWidth) {
		return (int) Math.min(MOST_BINS - 1, error / binWidth);
	}

	private static Optional<Gaussian> fit(final double[] density, final double binWidth) {
		if (density.length < 3)
			return Optional.empty();
		final WeightedObservedPoints points = new WeightedObservedPoints();
		for (int i = 0; i < density.length; i++)
			points.add((i + 0.5) * binWidth, density[i]);
		try {
			final double[] norm = GaussianCurveFitter.create().withMaxIterations(MOST_ITERATIONS)
				.fit(points.toList());
			return Optional.of(new Gaussian(norm[1], Math.abs(norm[2]), norm[0]));
		} catch (final MathIllegalArgumentException | MathIllegalStateException e) {
			return Optional.empty();
		}
	}

	@Override
	public double[] density() {
		return density.clone();
	}
}
