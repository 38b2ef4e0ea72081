
package io.github.knotresolver.contour;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * Orders the pixels of an unbranched skeleton by their geodesic distance from
 * the fixed end: the length of the shortest way that stays on the skeleton,
 * where a step to a side neighbour counts 1 and to a corner neighbour the
 * square root of 2 (quasi-Euclidean). Sources: P. Soille, Morphological Image
 * Analysis, Springer 1999, doi:10.1007/978-3-662-03939-7; J. Piper and E.
 * Granum, Computing distance transformations in convex and non-convex domains,
 * Pattern Recognition 20 (1987) 599-615, doi:10.1016/0031-3203(87)90030-6. O(n
 * log n).
 */
public final class GeodesicOrder {

	private GeodesicOrder() {
	}

	/**
	 * The quasi-Euclidean geodesic distances.
	 *
	 * @param pixels pixels with whole coordinates, each once, at least one
	 * @param fixedEnd any point; the pixel nearest to it (the first of equals)
	 *          has distance 0
	 * @return for each pixel its distance in pixels; infinite where no way leads
	 */
	public static double[] distances(final List<Point> pixels, final Point fixedEnd) {
		if (pixels.isEmpty())
			throw new IllegalArgumentException(
				"There must be at least one pixel to order, but there is none.");
		final Map<Point, Integer> index = new HashMap<>();
		for (int i = 0; i < pixels.size(); i++)
			index.put(pixels.get(i), i);
		final double[] distance = new double[pixels.size()];
		Arrays.fill(distance, Double.POSITIVE_INFINITY);
		spread(pixels, index, distance, nearest(pixels, fixedEnd));
		return distance;
	}

	/**
	 * The pixels in the order of their distance; those of equal distance stay in
	 * the order given, those that cannot be reached are left out.
	 *
	 * @param pixels pixels with whole coordinates, each once, at least one
	 * @param fixedEnd the order begins at the pixel nearest to this point
	 * @return the pixels' centres in order
	 */
	public static Polyline order(final List<Point> pixels, final Point fixedEnd) {
		final double[] distance = distances(pixels, fixedEnd);
		final List<Integer> order = new ArrayList<>();
		for (int i = 0; i < distance.length; i++)
			if (Double.isFinite(distance[i]))
				order.add(i);
		order.sort(Comparator.comparingDouble(i -> distance[i]));
		return Polyline.of(order.stream().map(pixels::get).toList());
	}

	private static int nearest(final List<Point> pixels, final Point fixedEnd) {
		int best = 0;
		for (int i = 1; i < pixels.size(); i++)
			if (pixels.get(i).distanceTo(fixedEnd) < pixels.get(best).distanceTo(fixedEnd))
				best = i;
		return best;
	}

	private record Reached(int pixel, double distance) {
	}

	private static void spread(final List<Point> pixels, final Map<Point, Integer> index,
		final double[] distance, final int seed) {
		final PriorityQueue<Reached> queue = new PriorityQueue<>(
			Comparator.comparingDouble(Reached::distance).thenComparingInt(Reached::pixel));
		distance[seed] = 0;
		queue.add(new Reached(seed, 0));
		while (!queue.isEmpty()) {
			final Reached r = queue.remove();
			if (r.distance > distance[r.pixel])
				continue;
			for (int dy = -1; dy <= 1; dy++)
				for (int dx = -1; dx <= 1; dx++) {
					final Point p = pixels.get(r.pixel);
					final Integer n = index.get(new Point(p.x() + dx, p.y() + dy));
					final double d = r.distance + Math.sqrt(Math.abs(dx) + Math.abs(dy));
					if (n != null && d < distance[n]) {
						distance[n] = d;
						queue.add(new Reached(n, d));
					}
				}
		}
	}
}
