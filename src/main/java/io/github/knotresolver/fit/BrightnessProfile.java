package io.github.knotresolver.fit;

import java.util.List;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;

import io.github.knotresolver.fit.LineEstimator.Example;
import io.github.knotresolver.fit.LineEstimator.LineEstimate;

/**
 * How bright the filament is along its length, relative to its mean: a dim tip is still
 * the tip. The profile is piecewise linear; as the picture of a chain is linear in its
 * brightness, it follows from linear least squares over all examples, held near 1 where
 * the pictures say little. If it is noticeable so, it is held straight instead of near 1: a
 * dim tip that is taken for brighter than it is makes the fitted curve end before it.
 */
final class BrightnessProfile {

	private BrightnessProfile() {
	}

	/**
	 * @param examples frames and curves
	 * @param line the line, uniform
	 * @return relative brightness at equal spacing from the fixed end to the tip
	 */
	static double[] estimate(final List<Example> examples, final LineEstimate line) {
		final double length = examples.get(0).chain().length();
		final int knots = Math.max(FitTuning.FEWEST_KNOTS,
			Math.min(FitTuning.MOST_KNOTS, 1 + (int) Math.rint(length / FitTuning.KNOT_SPACING)));
		final double[][] matrix = new double[knots][knots];
		final double[] right = new double[knots];
		hold(matrix, right, FitTuning.PROFILE_HOLD * examples.size());
		for (final Example example : examples)
			add(example, line, matrix, right);
		if (!noticeable(solved(matrix, right)))
			return new double[]{1};
		hold(matrix, right,
			-(1 - FitTuning.PROFILE_PULL) * FitTuning.PROFILE_HOLD * examples.size());
		holdStraight(matrix, FitTuning.PROFILE_HOLD * examples.size());
		final double[] profile = solved(matrix, right);
		noticeable(profile);
		return profile;
	}

	/** Draws all knots towards 1. */
	private static void hold(final double[][] matrix, final double[] right, final double weight) {
		for (int k = 0; k < right.length; k++) {
			matrix[k][k] += weight;
			right[k] += weight;
		}
	}

	/** Draws every knot towards the middle of its neighbours. */
	private static void holdStraight(final double[][] matrix, final double weight) {
		final double[] bend = {-0.5, 1, -0.5};
		for (int k = 1; k + 1 < matrix.length; k++)
			for (int i = 0; i < bend.length; i++)
				for (int j = 0; j < bend.length; j++)
					matrix[k - 1 + i][k - 1 + j] += weight * bend[i] * bend[j];
	}

	private static double[] solved(final double[][] matrix, final double[] right) {
		return new CholeskyDecomposition(new Array2DRowRealMatrix(matrix, true)).getSolver()
			.solve(new ArrayRealVector(right, true)).toArray();
	}

	private static void add(final Example example, final LineEstimate line, final double[][] matrix,
		final double[] right) {
		final int knots = right.length;
		final LineEstimator.Around around = example.around();
		final double[][] pictures = new double[knots][];
		for (int k = 0; k < knots; k++) {
			final double[] hat = new double[knots];
			hat[k] = 1;
			pictures[k] = ChainPixels.draw(example.frame(), line.model().withBrightness(hat),
				example.chain(), around.patch());
		}
		final double[] pixels = around.part().pixels();
		for (int i = 0; i < pixels.length; i++) {
			if (!around.near()[i])
				continue;
			final double value = (pixels[i] - line.background()) / line.amplitude();
			if (isCutOff(around.part(), i, line, pictures))
				continue;
			for (int k = 0; k < knots; k++) {
				if (pictures[k][i] == 0)
					continue;
				right[k] += pictures[k][i] * value;
				for (int m = 0; m < knots; m++)
					matrix[k][m] += pictures[k][i] * pictures[m][i];
			}
		}
	}

	/** Whether a line as it is expected is cut off somewhere. */
	private static boolean isCutOff(final NormalizedFrame frame, final int at,
		final LineEstimate line, final double[][] pictures) {
		double uniform = 0;
		for (final double[] picture : pictures)
			uniform += picture[at];
		return line.model().kind() == LineModel.Kind.ADDITIVE
			&& frame.hides(at, line.background() + line.amplitude() * uniform);
	}

	private static boolean noticeable(final double[] profile) {
		boolean varies = false;
		for (int k = 0; k < profile.length; k++) {
			profile[k] = Math.max(FitTuning.DIMMEST, Math.min(FitTuning.BRIGHTEST, profile[k]));
			varies |= Math.abs(profile[k] - 1) > FitTuning.UNEVEN;
		}
		return varies;
	}
}
