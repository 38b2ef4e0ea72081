
package io.github.knotresolver.measure;

/**
 * A measured value and how sure it is.
 *
 * @param value the value; NaN if it is missing
 * @param standardError its standard error, so that value ± 1.96 standard errors
 *          holds the truth in about 95 % of cases; NaN if it has none, as a
 *          count
 */
public record Estimate(double value, double standardError) {

	/** There is no value. */
	public static final Estimate MISSING = new Estimate(Double.NaN, Double.NaN);

	/** @return this value in another unit */
	Estimate times(final double factor) {
		return new Estimate(value * factor, standardError * Math.abs(factor));
	}
}
