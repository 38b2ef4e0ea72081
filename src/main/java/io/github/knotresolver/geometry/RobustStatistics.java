package io.github.knotresolver.geometry;

/**
 * What medians say of a normal distribution. Source: P. J. Rousseeuw and C. Croux,
 * Alternatives to the Median Absolute Deviation, J. Am. Stat. Assoc. 88 (1993) 1273-1283,
 * doi:10.1080/01621459.1993.10476408.
 */
public final class RobustStatistics {

	/** Standard deviation over median absolute deviation. */
	public static final double MAD_TO_SD = 1.4826;

	/** Standard error of a median over that of a mean: the root of half of pi. */
	public static final double MEDIAN_TO_MEAN_ERROR = 1.2533;

	private RobustStatistics() {
	}
}
