package io.github.knotresolver.fit;

import java.util.List;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;

import io.github.knotresolver.fit.LineEstimator.Estimate;
import io.github.knotresolver.fit.LineEstimator.Example;

/**
 * How bright the filament is along its length, relative to its mean: a dim tip is still
 * the tip. The profile is piecewise linear; as the picture of a chain is linear in its
 * brightness, it follows from linear least squares over all examples, held near 1 where
 * the pictures say little.
 */
final class BrightnessProfile {

	/** Distance of the profile's knots in pixels, about. */
	private static final double SPACING = 12;

	private static final int FEWEST_KNOTS = 4;
	private static final int MOST_KNOTS = 12;

	/** Weight of being 1, in pixels of a strand. */
	private static final double HOLD = 5;

	/** A profile that stays within this of 1 is taken to be uniform. */
	private static final double NOTICEABLE = 0.15;

	private static final double DIMMEST = 0.25;
	private static final double BRIGHTEST = 2;

	private BrightnessProfile() {
	}

	/**
	 * @param examples frames and curves
	 * @param line the line, uniform
	 * @return relative brightness at equal spacing from the fixed end to the tip
	 */
	static double[] estimate(final List<Example> examples, final Estimate line) {
		final double length = examples.get(0).chain().length();
		final int knots = Math.max(FEWEST_KNOTS,
			Math.min(MOST_KNOTS, 1 + (int) Math.rint(length / SPACING)));
		final double[][] matrix = new double[knots][knots];
		final double[] right = new double[knots];
		for (int k = 0; k < knots; k++) {
			matrix[k][k] = HOLD * examples.size();
			right[k] = HOLD * examples.size();
		}
		for (final Example example : examples)
			add(example, line, matrix, right);
		final double[] profile = new CholeskyDecomposition(new Array2DRowRealMatrix(matrix, false))
			.getSolver().solve(new ArrayRealVector(right, false)).toArray();
		return noticeable(profile) ? profile : new double[]{1};
	}

	private static void add(final Example example, final Estimate line, final double[][] matrix,
		final double[] right) {
		final int knots = right.length;
		final double[][] pictures = new double[knots][];
		for (int k = 0; k < knots; k++) {
			final double[] hat = new double[knots];
			hat[k] = 1;
			pictures[k] = Neighbourhood.draw(example.frame(), line.model().withBrightness(hat),
				example.chain());
		}
		for (int i = 0; i < example.near().length; i++) {
			if (!example.near()[i])
				continue;
			final double value = (example.frame().pixels()[i] - line.background())
				/ line.amplitude();
			for (int k = 0; k < knots; k++) {
				if (pictures[k][i] == 0)
					continue;
				right[k] += pictures[k][i] * value;
				for (int m = 0; m < knots; m++)
					matrix[k][m] += pictures[k][i] * pictures[m][i];
			}
		}
	}

	private static boolean noticeable(final double[] profile) {
		boolean varies = false;
		for (int k = 0; k < profile.length; k++) {
			profile[k] = Math.max(DIMMEST, Math.min(BRIGHTEST, profile[k]));
			varies |= Math.abs(profile[k] - 1) > NOTICEABLE;
		}
		return varies;
	}
}
