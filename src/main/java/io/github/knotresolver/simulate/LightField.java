
package io.github.knotresolver.simulate;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * Light that adds up: lines and points seen through a Gaussian point spread
 * function. A long straight line of brightness 1 has 1 on its middle.
 */
public final class LightField {

	/** Distance of the points that a line is made of, in pixels. */
	private static final double STEP = 0.25;

	/** Where the point spread function ends, in sigmas. */
	private static final double REACH = 4.5;

	private final int width;
	private final double sigma;
	private final double[] light;
	private final double[] across;

	/**
	 * @param width of the picture in pixels
	 * @param height of the picture in pixels
	 * @param sigma width of the point spread function in pixels
	 */
	public LightField(final int width, final int height, final double sigma) {
		this.width = width;
		this.sigma = sigma;
		light = new double[width * height];
		across = new double[2 * radius() + 1];
	}

	/** @return the light of every pixel, row by row */
	public double[] values() {
		return light;
	}

	/**
	 * Adds a line: the sum over its points approximates the line integral.
	 *
	 * @param curve the line in pixels
	 * @param brightness of its middle
	 */
	public void addLine(final Polyline curve, final double brightness) {
		final Polyline q = curve.resampled(STEP);
		final double perPixel = brightness / (sigma * Math.sqrt(2 * Math.PI));
		for (int i = 0; i < q.size(); i++) {
			final double before = i > 0 ? q.arc(i) - q.arc(i - 1) : 0;
			final double after = i < q.size() - 1 ? q.arc(i + 1) - q.arc(i) : 0;
			addSpot(q.point(i), perPixel * (before + after) / 2);
		}
	}

	/** Adds a point whose middle has the given brightness. */
	void addSpot(final Point p, final double brightness) {
		final int column = (int) Math.rint(p.x()), row = (int) Math.rint(p.y());
		for (int k = -radius(); k <= radius(); k++)
			across[k + radius()] = falloff(column + k - p.x());
		for (int y = Math.max(0, row - radius()); y <= Math.min(light.length / width - 1,
			row + radius()); y++) {
			final double here = brightness * falloff(y - p.y());
			for (int k = Math.max(-radius(), -column); k <= Math.min(radius(),
				width - 1 - column); k++)
				light[y * width + column + k] += here * across[k + radius()];
		}
	}

	private double falloff(final double distance) {
		return StrictMath.exp(-distance * distance / (2 * sigma * sigma));
	}

	private int radius() {
		return (int) Math.ceil(REACH * sigma);
	}
}
