
package io.github.knotresolver.measure;

import java.util.Arrays;

import io.github.knotresolver.geometry.Polyline;

/**
 * A contour's points over its arc length, in calibrated units, and the window
 * of Savitzky and Golay around any of them.
 */
final class Samples {

	private final double[] s;
	private final double[] x;
	private final double[] y;

	private Samples(final double[] s, final double[] x, final double[] y) {
		this.s = s;
		this.x = x;
		this.y = y;
	}

	/** @return the polyline's points, scaled by {@code pixelSize} */
	static Samples of(final Polyline contour, final double pixelSize) {
		final int n = contour.size();
		final double[] s = new double[n], x = new double[n], y = new double[n];
		for (int i = 0; i < n; i++) {
			s[i] = contour.arc(i) * pixelSize;
			x[i] = contour.x(i) * pixelSize;
			y[i] = contour.y(i) * pixelSize;
		}
		return new Samples(s, x, y);
	}

	/** @return values, as y, over their index */
	static Samples overIndex(final double[] values) {
		final double[] index = new double[values.length];
		for (int i = 0; i < index.length; i++)
			index[i] = i;
		return new Samples(index, index, values);
	}

	/** @return the same points over another arc length */
	Samples over(final double[] arc) {
		return new Samples(arc, x, y);
	}

	int size() {
		return s.length;
	}

	double s(final int i) {
		return s[i];
	}

	double x(final int i) {
		return x[i];
	}

	double y(final int i) {
		return y[i];
	}

	double length() {
		return s[s.length - 1];
	}

	double spacing() {
		return length() / (s.length - 1);
	}

	/**
	 * The full window nearest to an arc length: near an end it is shifted
	 * inwards, not cut, so that as many points speak there as elsewhere. It is
	 * widened until it holds {@code least} points.
	 *
	 * @return index of the first point, and index after the last
	 */
	int[] window(final double at, final double width, final int least) {
		final double start = Math.max(0, Math.min(at - width / 2, length() - width));
		int from = lowerBound(start - 1e-9 * width);
		int to = Math.max(from, lowerBound(start + width * (1 + 1e-9)));
		while (to - from < Math.min(least, s.length)) {
			final boolean left = to == s.length || (from > 0 && at - s[from - 1] < s[to] - at);
			if (left)
				from--;
			else
				to++;
		}
		return new int[]{from, to};
	}

	/** Index of the first point at or after {@code at}. */
	private int lowerBound(final double at) {
		int i = Arrays.binarySearch(s, at);
		if (i < 0)
			return -i - 1;
		while (i > 0 && s[i - 1] >= at)
			i--;
		return i;
	}
}
