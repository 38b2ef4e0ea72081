package io.github.knotresolver.fit;

import java.util.Arrays;

/**
 * What each link of a chain whose light adds up gives to each pixel in its reach, and how that
 * changes when the link's nodes move. One entry for each pair of a pixel and a link; a pixel's
 * entries are a list, from the last link to the first. Not for several threads at a time.
 */
final class LinkShares {

	/** Those of about 30 links. */
	private static final int FEWEST = 1 << 12;

	private int size;
	private int[] link = {}, next = {};

	// What was drawn: the value, its part across the link, and where the pixel is.
	private double[] value = {}, across = {}, along = {}, beside = {};

	// Slopes by the nodes of the link.
	private double[] startX = {}, startY = {}, endX = {}, endY = {};

	private int[] nodes = new int[64];
	private double[] jacobian = new double[128];

	void clear() {
		size = 0;
	}

	/** @return how many entries there are */
	int size() {
		return size;
	}

	/** Makes room for so many entries more. */
	void reserve(final int more) {
		if (size + more <= next.length)
			return;
		final int room = Math.max(FEWEST, Math.max(size + more, 2 * next.length));
		link = Arrays.copyOf(link, room);
		next = Arrays.copyOf(next, room);
		value = Arrays.copyOf(value, room);
		across = Arrays.copyOf(across, room);
		along = Arrays.copyOf(along, room);
		beside = Arrays.copyOf(beside, room);
		startX = new double[room];
		startY = new double[room];
		endX = new double[room];
		endY = new double[room];
	}

	/**
	 * Adds an entry; there is room for it.
	 *
	 * @param ofLink the link
	 * @param before the pixel's last entry; -1 if it has none
	 * @param light what the link gives to the pixel
	 * @param profile of an infinite line as far from the pixel
	 * @param t along the link, in pixels from its start
	 * @param n across the link, in pixels
	 * @return the entry
	 */
	int add(final int ofLink, final int before, final double light, final double profile,
		final double t, final double n) {
		final int e = size++;
		link[e] = ofLink;
		next[e] = before;
		value[e] = light;
		across[e] = profile;
		along[e] = t;
		beside[e] = n;
		return e;
	}

	/**
	 * Finds the slopes of the entries of one link.
	 *
	 * @param from the first
	 * @param to the last and 1
	 * @param l length of the link
	 * @param ux its direction, a unit vector
	 * @param uy its direction
	 * @param gauss of the squared distance
	 * @param sigma2 square of its width
	 */
	void findSlopes(final int from, final int to, final double l, final double ux, final double uy,
		final Table gauss, final double sigma2) {
		final double density = 1 / Math.sqrt(2 * Math.PI * sigma2);
		for (int e = from; e < to; e++) {
			final double t = along[e];
			startX[e] = gauss.at(t * t);
			endX[e] = gauss.at((t - l) * (t - l));
		}
		// All at the same index: Java's compiler takes several at a time.
		for (int e = from; e < to; e++) {
			final double begin = across[e] * density * startX[e];
			final double end = across[e] * density * endX[e];
			final double shift = value[e] * beside[e] / sigma2;
			final double turn = (begin - end) * beside[e] / l;
			final double startAcross = shift * (1 - along[e] / l) - turn;
			final double endAcross = shift * along[e] / l + turn;
			startX[e] = startAcross * -uy - begin * ux;
			startY[e] = startAcross * ux - begin * uy;
			endX[e] = endAcross * -uy + end * ux;
			endY[e] = endAcross * ux + end * uy;
		}
	}

	/**
	 * Adds a pixel's entries to normal equations, those of neighbouring links joined.
	 *
	 * @param last the pixel's last entry
	 */
	void addPixel(final int last, final double weight, final double residual,
		final NodeSystem system) {
		int count = 0;
		for (int e = last; e >= 0; e = next[e]) {
			if (count + 2 > nodes.length) {
				nodes = Arrays.copyOf(nodes, 2 * nodes.length);
				jacobian = Arrays.copyOf(jacobian, 2 * jacobian.length);
			}
			// The list runs from the last link to the first.
			if (count == 0 || nodes[count - 1] != link[e] + 1) {
				nodes[count] = link[e] + 1;
				jacobian[2 * count] = 0;
				jacobian[2 * count + 1] = 0;
				count++;
			}
			jacobian[2 * count - 2] += endX[e];
			jacobian[2 * count - 1] += endY[e];
			nodes[count] = link[e];
			jacobian[2 * count] = startX[e];
			jacobian[2 * count + 1] = startY[e];
			count++;
		}
		system.add(nodes, jacobian, count, weight, residual);
	}
}
