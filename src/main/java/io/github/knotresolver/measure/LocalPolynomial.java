
package io.github.knotresolver.measure;

import java.util.Arrays;

/**
 * Least-squares fit of a polynomial curve (x(s), y(s)) to the points of a
 * window, the step behind Savitzky and Golay's filter (1964,
 * doi:10.1021/ac60214a047), for points that need not be equally spaced. The
 * polynomial is centred where it is evaluated, so its coefficients are the
 * value and the derivatives there.
 * <p>
 * One object is reused for many windows; it is not thread-safe. O(points) per
 * fit.
 */
final class LocalPolynomial {

	/** Added to the diagonal, relative: keeps coinciding points solvable. */
	private static final double RIDGE = 1e-13;

	private final int terms;
	private final double[] moments;
	private final double[] bx;
	private final double[] by;
	private final double[] cx;
	private final double[] cy;
	private final double[][] inverse;
	private final double[][] factor;
	private double scale;

	/** @param order degree of the polynomial, at least 1 */
	LocalPolynomial(final int order) {
		terms = order + 1;
		moments = new double[2 * order + 1];
		bx = new double[terms];
		by = new double[terms];
		cx = new double[terms];
		cy = new double[terms];
		inverse = new double[terms][terms];
		factor = new double[terms][terms];
	}

	/**
	 * Fits the points {@code from} (included) to {@code to} (excluded).
	 *
	 * @param c points along the curve, more than the order inside the window
	 * @param from index of the first point
	 * @param to index after the last point
	 * @param at arc length where value and derivatives are wanted
	 * @param halfWindow scale of the window, above 0
	 * @param gap points nearer to {@code at} than this are left out; negative to
	 *          use all
	 */
	void fit(final Samples c, final int from, final int to, final double at,
		final double halfWindow, final double gap) {
		scale = 1 / halfWindow;
		Arrays.fill(moments, 0);
		Arrays.fill(bx, 0);
		Arrays.fill(by, 0);
		for (int j = from; j < to; j++) {
			final double d = c.s(j) - at;
			if (Math.abs(d) > gap)
				add(d * scale, c.x(j), c.y(j));
		}
		invert();
		for (int i = 0; i < terms; i++) {
			cx[i] = dot(inverse[i], bx);
			cy[i] = dot(inverse[i], by);
		}
	}

	private void add(final double u, final double x, final double y) {
		double power = 1;
		for (int k = 0; k < terms; k++, power *= u) {
			moments[k] += power;
			bx[k] += power * x;
			by[k] += power * y;
		}
		for (int k = terms; k < moments.length; k++, power *= u)
			moments[k] += power;
	}

	/** @return derivative {@code d} of x with respect to arc length */
	double x(final int d) {
		return d < terms ? cx[d] * unit(d) : 0;
	}

	/** @return derivative {@code d} of y with respect to arc length */
	double y(final int d) {
		return d < terms ? cy[d] * unit(d) : 0;
	}

	/** @return variance of derivative {@code d} for unit noise of every point */
	double variance(final int d) {
		return d < terms ? inverse[d][d] * unit(d) * unit(d) : 0;
	}

	/**
	 * How much derivative {@code d} changes when a point moves by 1: a polynomial
	 * in that point's arc length less that of the evaluation.
	 *
	 * @param d order of the derivative
	 * @param factor multiplies the weights
	 * @param into receives the polynomial's coefficients, lowest first
	 */
	void copyWeights(final int d, final double factor, final double[] into) {
		double power = unit(d) * factor;
		for (int k = 0; k < terms; k++, power *= scale)
			into[k] = d < terms ? inverse[d][k] * power : 0;
	}

	/** From a coefficient in scaled arc length to a derivative: d! scale^d. */
	private double unit(final int d) {
		double u = 1;
		for (int k = 1; k <= d; k++)
			u *= k * scale;
		return u;
	}

	/**
	 * Inverts the normal matrix by its Cholesky factor, whose diagonal is kept as
	 * reciprocals.
	 */
	private void invert() {
		for (int i = 0; i < terms; i++) {
			final double[] row = factor[i];
			for (int j = 0; j <= i; j++) {
				double sum = moments[i + j] * (i == j ? 1 + RIDGE : 1);
				for (int k = 0; k < j; k++)
					sum -= row[k] * factor[j][k];
				row[j] = i == j
					? 1 / Math.sqrt(Math.max(sum, Double.MIN_NORMAL))
					: sum * factor[j][j];
			}
		}
		for (int column = 0; column < terms; column++)
			solveUnit(column, inverse[column]);
	}

	/** A row of the inverse, which is symmetric: its column. */
	private void solveUnit(final int column, final double[] out) {
		for (int i = 0; i < column; i++)
			out[i] = 0;
		for (int i = column; i < terms; i++) {
			double sum = i == column ? 1 : 0;
			for (int k = column; k < i; k++)
				sum -= factor[i][k] * out[k];
			out[i] = sum * factor[i][i];
		}
		for (int i = terms - 1; i >= 0; i--) {
			double sum = out[i];
			for (int k = i + 1; k < terms; k++)
				sum -= factor[k][i] * out[k];
			out[i] = sum * factor[i][i];
		}
	}

	private static double dot(final double[] a, final double[] b) {
		double sum = 0;
		for (int i = 0; i < a.length; i++)
			sum += a[i] * b[i];
		return sum;
	}
}
