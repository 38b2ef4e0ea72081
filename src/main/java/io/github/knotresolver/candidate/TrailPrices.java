package io.github.knotresolver.candidate;

/**
 * Weights of the parts of a trail's price. The defaults were chosen on
 * simulated spirals with known truth.
 *
 * @param turning pixels for a right-angled turn; a reversal costs twice as much
 * @param uncovered per pixel of skeleton left out
 * @param lengthMisfit per pixel too long or too short
 * @param overlap per pixel walked a second time, if the length is known
 * @param overlapUnknown the same if the length is not known and nothing else
 *          holds a trail back from walking everything twice
 */
public record TrailPrices(double turning, double uncovered, double lengthMisfit, double overlap,
	double overlapUnknown) {

	/** What has been found to work. */
	public static final TrailPrices DEFAULT = new TrailPrices(6, 1, 1, 0.1, 0.5);

	public TrailPrices {
		if (!(turning >= 0 && uncovered >= 0 && lengthMisfit >= 0 && overlap >= 0
			&& overlapUnknown >= 0))
			throw new IllegalArgumentException(
				"Weights of prices must be at least 0, but are turning " + turning + ", uncovered "
					+ uncovered + ", lengthMisfit " + lengthMisfit + ", overlap " + overlap
					+ " and overlapUnknown " + overlapUnknown + ".");
	}
}
