package io.github.knotresolver;

import net.imglib2.img.Img;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/** Curves, and one-pixel lines along them, for tests that need larger ones than one draws. */
public final class Drawn {

	private Drawn() {
	}

	/**
	 * @param xy columns and rows in turn, corner by corner
	 * @return the polyline through the corners
	 */
	public static Polyline line(final double... xy) {
		final double[] x = new double[xy.length / 2], y = new double[x.length];
		for (int i = 0; i < x.length; i++) {
			x[i] = xy[2 * i];
			y[i] = xy[2 * i + 1];
		}
		return Polyline.of(x, y);
	}

	/**
	 * @param start where it begins
	 * @param curl its curvature, in radians per pixel
	 * @return 60 px of a filament that beats, from its clamp on
	 */
	public static Polyline arc(final Point start, final double curl) {
		final double[] x = new double[61], y = new double[61];
		x[0] = start.x();
		y[0] = start.y();
		for (int i = 1; i < x.length; i++) {
			x[i] = x[i - 1] + Math.cos(curl * i);
			y[i] = y[i - 1] + Math.sin(curl * i);
		}
		return Polyline.of(x, y);
	}

	/**
	 * @param curves what to draw
	 * @return the pixels that a pen moving in small steps marks, without the corner pixels
	 *         of the staircase
	 */
	public static Img<BitType> skeleton(final int width, final int height,
		final Polyline... curves) {
		final Img<BitType> image = ArrayImgs.bits(width, height);
		for (final Polyline curve : curves)
			for (int i = 1; i < curve.size(); i++)
				link(image, curve, i);
		return image;
	}

	private static void link(final Img<BitType> image, final Polyline c, final int i) {
		final long x0 = Math.round(c.x(i - 1)), y0 = Math.round(c.y(i - 1));
		final long dx = Math.round(c.x(i)) - x0, dy = Math.round(c.y(i)) - y0;
		final long n = Math.max(1, Math.max(Math.abs(dx), Math.abs(dy)));
		for (long k = 0; k <= n; k++)
			image.getAt(x0 + Math.round((double) dx * k / n), y0 + Math.round((double) dy * k / n))
				.set(true);
	}
}
