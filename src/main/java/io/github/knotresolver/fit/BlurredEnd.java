
package io.github.knotresolver.fit;

import org.apache.commons.math3.special.Erf;

/**
 * The end of a line that a lens draws and the camera, or the brightest strand, cuts off. Before
 * it is cut off, light is A exp(-n²/2s²) Φ(r/s), n across the line and r before its end: as
 * bright as at the squared distance n² - 2s² ln Φ(r/s) from a line without an end, and so it is
 * after.
 */
final class BlurredEnd {

	/**
	 * A Gaussian of width s that is cut off looks like exp(-(d²/2σ²)^p) with s = σ p^-0.4: exact
	 * to 1 % for amplitudes up to twelve times the ceiling, where p is 5.
	 */
	private static final double NARROWER = -0.4;

	/** Farther before an end, in units of s, it is not felt. */
	private static final double FELT = 3.5;

	private final double reach;
	private final double from;
	private final Table farther;
	private final Table slope;

	/**
	 * @param sigma of the line in pixels
	 * @param power of its profile
	 * @param reach distance beyond which it is dark
	 */
	BlurredEnd(final double sigma, final double power, final double reach) {
		final double s = sigma * Math.pow(power, NARROWER);
		this.reach = reach;
		from = FELT * s;
		farther = new Table(reach + from,
			at -> -2 * s * s * Math.log(0.5 * Erf.erfc((reach - at) / (Math.sqrt(2) * s))));
		slope = new Table(reach + from, at -> {
			final double r = (at - reach) / s;
			return -2 * s * Math.exp(-0.5 * r * r)
				/ (Math.sqrt(2 * Math.PI) * 0.5 * Erf.erfc(-r / Math.sqrt(2)));
		});
	}

	/** Where along a line, in pixels before its end, the end is felt. */
	double felt() {
		return from;
	}

	/**
	 * @param before the end, in pixels, negative beyond
	 * @return what the end adds to the squared distance
	 */
	double farther(final double before) {
		return before < -reach ? reach * reach : farther.at(before + reach);
	}

	/**
	 * @param before the end, in pixels, negative beyond
	 * @return the slope of {@link #farther}
	 */
	double slope(final double before) {
		return slope.at(Math.max(0, before + reach));
	}
}
