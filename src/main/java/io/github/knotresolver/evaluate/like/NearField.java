package io.github.knotresolver.evaluate.like;

import java.util.Arrays;

import io.github.knotresolver.geometry.Polyline;

/**
 * For the pixels near a curve, how far it is and where. O(length · reach²).
 */
final class NearField {

	/** Distance of the points that the curve is made of, in pixels. */
	private static final double STEP = 0.25;

	private final double[] distance;
	private final double[] arc;

	/**
	 * @param curve the curve in pixels
	 * @param width of the picture
	 * @param height of the picture
	 * @param reach how far from the curve pixels are looked at
	 */
	NearField(final Polyline curve, final int width, final int height, final double reach) {
		distance = new double[width * height];
		arc = new double[width * height];
		Arrays.fill(distance, Double.POSITIVE_INFINITY);
		final Polyline points = curve.resampled(STEP);
		final int r = (int) Math.ceil(reach);
		for (int i = 0; i < points.size(); i++) {
			final int column = (int) Math.rint(points.x(i)), row = (int) Math.rint(points.y(i));
			for (int y = Math.max(0, row - r); y <= Math.min(height - 1, row + r); y++)
				for (int x = Math.max(0, column - r); x <= Math.min(width - 1, column + r); x++) {
					final double d = Math.hypot(x - points.x(i), y - points.y(i));
					if (d <= reach && d < distance[y * width + x]) {
						distance[y * width + x] = d;
						arc[y * width + x] = points.arc(i) / points.length();
					}
				}
		}
	}

	/** @return pixels from the curve; infinite beyond the reach */
	double distance(final int pixel) {
		return distance[pixel];
	}

	/** @return place of the nearest point along the curve, 0..1 */
	double arc(final int pixel) {
		return arc[pixel];
	}
}
