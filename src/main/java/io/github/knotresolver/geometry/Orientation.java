package io.github.knotresolver.geometry;

import java.math.BigDecimal;

/**
 * On which side of a line a point lies, exactly: floating point where its error
 * bound allows an answer, decimal arithmetic without rounding where not. The
 * bound is that of Shewchuk 1997, <i>Adaptive precision floating-point arithmetic
 * and fast robust geometric predicates</i>, doi:10.1007/PL00009321.
 */
final class Orientation {

	/** (3 + 16 ε) ε with ε = 2⁻⁵³. */
	private static final double BOUND = 3.3306690738754716e-16;

	private Orientation() {
	}

	/**
	 * @param a start of the line
	 * @param b another point of the line
	 * @param p the point
	 * @return the sign of (b - a) × (p - a): 1, -1, or 0 if all three lie on one line;
	 *         exact for finite coordinates
	 */
	static int of(final Point a, final Point b, final Point p) {
		final double left = (a.x() - p.x()) * (b.y() - p.y()),
			right = (a.y() - p.y()) * (b.x() - p.x());
		final double cross = left - right;
		return Math.abs(cross) > BOUND * (Math.abs(left) + Math.abs(right))
			? (int) Math.signum(cross)
			: exact(a, b, p);
	}

	private static int exact(final Point a, final Point b, final Point p) {
		final BigDecimal px = new BigDecimal(p.x()), py = new BigDecimal(p.y());
		return new BigDecimal(a.x()).subtract(px).multiply(new BigDecimal(b.y()).subtract(py))
			.subtract(
				new BigDecimal(a.y()).subtract(py).multiply(new BigDecimal(b.x()).subtract(px)))
			.signum();
	}
}
