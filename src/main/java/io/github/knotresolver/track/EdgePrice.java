package io.github.knotresolver.track;

/** What it costs to go from a vertex of a trellis to one of a later frame. */
@FunctionalInterface
public interface EdgePrice {

	/**
	 * Must give the same price whenever it is asked.
	 *
	 * @param fromFrame 0-based index of the earlier frame
	 * @param from vertex in it
	 * @param toFrame 0-based index of the later frame: the next that has vertices
	 * @param to vertex in it
	 * @return the price, finite
	 */
	double between(int fromFrame, int from, int toFrame, int to);
}
