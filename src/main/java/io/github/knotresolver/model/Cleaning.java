package io.github.knotresolver.model;

/**
 * Parameters of cleaning a frame. Stretch and median are always on; the
 * Laplacian of Gaussian is for uneven background.
 *
 * @param logSize edge of the Laplacian-of-Gaussian kernel in pixels, odd,
 *          3..99; 0 switches it off
 * @param logSigma its standard deviation in pixels, above 0; 0 if it is off
 */
public record Cleaning(int logSize, double logSigma) {

	/** Stretch and median only. */
	public static final Cleaning DEFAULT = new Cleaning(0, 0);

	public Cleaning {
		if (logSize != 0 || logSigma != 0) {
			if (logSize < 3 || logSize > 99 || logSize % 2 == 0)
				throw new UserException(
					"log_size must be an odd number of pixels from 3 to 99 (or 0 for off), but is "
						+ logSize + ".");
			if (!(logSigma > 0 && logSigma <= 50))
				throw new UserException("log_sigma must be above 0 and at most 50 pixels, but is "
					+ ShownNumber.of(logSigma) + ".");
		}
	}

	/** @return whether the Laplacian of Gaussian is applied */
	public boolean enhances() {
		return logSize > 0;
	}
}
