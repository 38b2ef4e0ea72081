package io.github.knotresolver.evaluate.like;

/**
 * What a movie looks like, in its grey values and pixels.
 *
 * @param background median of the pixels far from the filament
 * @param noise standard deviation of the background from pixel to pixel: uneven
 *          light and specks do not count; 0 if it is cut off at black
 * @param noiseOnLine the same on the filament's middle, which shot noise makes
 *          larger; {@code noise} where the filament is cut off at white
 * @param peak brightness of the filament's middle above the background, as it is
 *          seen
 * @param width full width of the line at half its peak, as it is seen
 * @param saturating whether strands that cross are not brighter
 * @param profile the line before anything was cut off
 * @param along relative brightness in pieces of equal length, from the fixed end
 *          to the tip
 * @param range the movie's grey values
 */
record Appearance(double background, double noise, double noiseOnLine, double peak, double width,
	boolean saturating, LineProfile profile, double[] along, GreyRange range) {

	Appearance {
		along = along.clone();
	}

	@Override
	public double[] along() {
		return along.clone();
	}

	/** @return the brightest that a strand above the background can be */
	double ceiling() {
		return saturating ? peak : Double.POSITIVE_INFINITY;
	}

	/** @return the variance that light of {@code above} over the background adds */
	double shotVariance(final double above) {
		final double extra = noiseOnLine * noiseOnLine - noise * noise;
		return Math.max(0, extra) * Math.max(0, above) / peak;
	}
}
