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

	/** Numbers of an entry: what was drawn, its part across the link, and where the pixel is. */
	private static final int VALUE = 0, ACROSS = 1, ALONG = 2, BESIDE = 3, NUMBERS = 4;

	private final Table gauss;
	private final double perSigma2;
	private final double density;

	private int size;
	private int[] link = {}, next = {};
	/** Of each entry one after the other: they are asked for together. */
	private double[] entries = {};

	// Of each link of the chain that was drawn: its length, and its direction, a unit vector.
	private final double[] length, perLength, directionX, directionY;

	private int[] nodes = new int[64];
	private double[] jacobian = new double[128];

	/**
	 * @param gauss of the squared distance
	 * @param sigma2 square of its width
	 * @param links of the chains to come
	 */
	LinkShares(final Table gauss, final double sigma2, final int links) {
		this.gauss = gauss;
		perSigma2 = 1 / sigma2;
		density = 1 / Math.sqrt(2 * Math.PI * sigma2);
		length = new double[links];
		perLength = new double[links];
		directionX = new double[links];
		directionY = new double[links];
	}

	void clear() {
		size = 0;
	}

	/**
	 * Entries of a link are going to come.
	 *
	 * @param i the link
	 * @param l its length
	 * @param ux its direction, a unit vector
	 * @param uy its direction
	 */
	void begin(final int i, final double l, final double ux, final double uy) {
		length[i] = l;
		perLength[i] = 1 / l;
		directionX[i] = ux;
		directionY[i] = uy;
	}

	/** Makes room for so many entries more. */
	void reserve(final int more) {
		if (size + more <= next.length)
			return;
		final int room = Math.max(FEWEST, Math.max(size + more, 2 * next.length));
		link = Arrays.copyOf(link, room);
		next = Arrays.copyOf(next, room);
		entries = Arrays.copyOf(entries, NUMBERS * room);
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
		final int e = size++, at = NUMBERS * e;
		link[e] = ofLink;
		next[e] = before;
		entries[at + VALUE] = light;
		entries[at + ACROSS] = profile;
		entries[at + ALONG] = t;
		entries[at + BESIDE] = n;
		return e;
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
			nodes[count] = link[e];
			addSlopes(e, 2 * count);
			count++;
		}
		system.add(nodes, jacobian, count, weight, residual);
	}

	/** Adds how an entry changes with its link's end, and sets how it does with its start. */
	private void addSlopes(final int e, final int start) {
		final int i = link[e], at = NUMBERS * e;
		final double l = length[i], ux = directionX[i], uy = directionY[i];
		final double across = entries[at + ACROSS] * density, t = entries[at + ALONG];
		final double n = entries[at + BESIDE], perL = perLength[i];
		final double begin = across * gauss.at(t * t), end = across * gauss.at((t - l) * (t - l));
		final double shift = entries[at + VALUE] * n * perSigma2, turn = (begin - end) * n * perL;
		final double endAcross = shift * t * perL + turn, startAcross = shift - endAcross;
		jacobian[start - 2] += endAcross * -uy + end * ux;
		jacobian[start - 1] += endAcross * ux + end * uy;
		jacobian[start] = startAcross * -uy - begin * ux;
		jacobian[start + 1] = startAcross * ux - begin * uy;
	}
}
