package io.github.knotresolver.geometry;

/**
 * A point in pixels: origin top-left, an integer is a pixel centre, 0-based.
 *
 * @param x column coordinate in pixels
 * @param y row coordinate in pixels
 */
public record Point(double x, double y) {

	/**
	 * Euclidean distance to another point.
	 *
	 * @param other the other point
	 * @return the distance in pixels
	 */
	public double distanceTo(final Point other) {
		return Math.hypot(other.x - x, other.y - y);
	}

	@Override
	public String toString() {
		return x + "," + y;
	}
}
