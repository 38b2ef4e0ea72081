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

	/**
	 * @param from one end of a straight segment
	 * @param to its other end
	 * @return the distance in pixels to the nearest point of the segment
	 */
	public double distanceToSegment(final Point from, final Point to) {
		final double dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
		final double at = square == 0 ? 0 : ((x - from.x) * dx + (y - from.y) * dy) / square;
		final double inside = Math.max(0, Math.min(1, at));
		return distanceTo(new Point(from.x + inside * dx, from.y + inside * dy));
	}

	@Override
	public String toString() {
		return x + "," + y;
	}
}
