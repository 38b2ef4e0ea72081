
package io.github.knotresolver.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/** Curves whose geometry is known. */
final class Curves {

	private Curves() {
	}

	/** An arc that starts at angle {@code start}, turning towards +y. */
	static Polyline circle(final double radius, final double angle, final double start,
		final double step) {
		final int n = (int) Math.rint(radius * angle / step);
		final double[] x = new double[n + 1], y = new double[n + 1];
		for (int i = 0; i <= n; i++) {
			final double a = start + angle * i / n;
			x[i] = 100 + radius * Math.cos(a);
			y[i] = 100 + radius * Math.sin(a);
		}
		return Polyline.of(x, y);
	}

	/** y = amplitude sin(2π x / wavelength), equally spaced in arc length. */
	static Polyline sine(final double extent, final double amplitude, final double wavelength) {
		final int n = 20000;
		final double[] x = new double[n + 1], y = new double[n + 1];
		for (int i = 0; i <= n; i++) {
			x[i] = extent * i / n;
			y[i] = amplitude * Math.sin(2 * Math.PI * x[i] / wavelength);
		}
		return Polyline.of(x, y).resampled(1);
	}

	/** Independent Gaussian errors of every point, in x and in y. */
	static Polyline noisy(final Polyline p, final double sigma, final Random random) {
		return noisy(p, sigma, 0, random);
	}

	/** Gaussian errors, neighbours' with correlation {@code memory}. */
	static Polyline noisy(final Polyline p, final double sigma, final double memory,
		final Random random) {
		final double[] x = p.xs(), y = p.ys();
		final double kick = Math.sqrt(1 - memory * memory);
		double ex = random.nextGaussian(), ey = random.nextGaussian();
		for (int i = 0; i < x.length; i++) {
			x[i] += sigma * ex;
			y[i] += sigma * ey;
			ex = memory * ex + kick * random.nextGaussian();
			ey = memory * ey + kick * random.nextGaussian();
		}
		return Polyline.of(x, y);
	}

	/** The chain of pixel centres along a finely sampled curve. */
	static Polyline pixels(final Polyline fine) {
		final List<Point> chain = new ArrayList<>();
		for (int i = 0; i < fine.size(); i++) {
			final Point p = new Point(Math.rint(fine.x(i)), Math.rint(fine.y(i)));
			if (chain.isEmpty() || !chain.get(chain.size() - 1).equals(p))
				chain.add(p);
		}
		return Polyline.of(chain);
	}
}
