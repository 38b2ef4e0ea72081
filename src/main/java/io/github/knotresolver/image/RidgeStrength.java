package io.github.knotresolver.image;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.progress.Cancellation;

/**
 * How much a frame looks like a bright line, at every pixel: the second derivative
 * across, averaged along, in the best of eight directions. What varies slowly (background,
 * gradient, haze, vignette) has no part in it.
 */
public final class RidgeStrength {

	/** Number of directions. */
	public static final int DIRECTIONS = 8;

	/** Every third direction is a sample of the noise. */
	private static final int SAMPLED = 3;

	private final int width;
	private final float[] strength, noise;
	private final IntUnaryOperator directions;
	/** Directions that were asked for, from 1; most never are. */
	private final byte[] known;

	private RidgeStrength(final int width, final float[] strength,
		final IntUnaryOperator directions, final float[] noise) {
		this.width = width;
		this.strength = strength;
		this.directions = directions;
		this.noise = noise;
		known = new byte[strength.length];
	}

	/**
	 * Ridge strength in units of its own local noise: in a frame without lines each
	 * direction has mean 0 and standard deviation 1, the largest of the eight, which this
	 * is, about 1 on average, 1.5 on the crests of noise. O(n sigma) for n pixels.
	 * <p>
	 * Derivatives of Gaussians along directions: Freeman and Adelson 1991,
	 * doi:10.1109/34.93808.
	 *
	 * @implNote op names="knotresolver.ridgeStrength"
	 * @param frame a two-dimensional image; pixels without a value (NaN) count as the
	 *          lowest of the frame
	 * @param sigma standard deviation of the Gaussian in pixels, 0.5 to 50; best is that
	 *          of the line
	 * @return a new image of the same size: strength over noise, negative beside lines
	 */
	public static Img<FloatType> ofNoise(
		final RandomAccessibleInterval<? extends RealType<?>> frame, final double sigma) {
		if (!(sigma >= 0.5 && sigma <= 50))
			throw new IllegalArgumentException(
				"sigma must be from 0.5 to 50 pixels, but is " + sigma + ".");
		final int width = Pixels.width(frame);
		final RidgeStrength ridges = of(Hessian.of(Pixels.floats(frame), width, sigma), sigma);
		final float[] z = new float[ridges.strength.length];
		for (int i = 0; i < z.length; i++)
			z[i] = ridges.z(i);
		return Pixels.image(z, width);
	}

	static RidgeStrength of(final Hessian hessian, final double sigma) {
		return new Bank(hessian, ImageTuning.ALONG * sigma).best();
	}

	/** @return the response of one of the filters alone, at every pixel */
	static float[] inDirection(final Hessian hessian, final double sigma, final int direction) {
		final Bank bank = new Bank(hessian, ImageTuning.ALONG * sigma);
		bank.look(direction);
		return bank.best;
	}

	/** Without the average along: the principal curvature at every pixel; its noise is not known. */
	static RidgeStrength principal(final Hessian h) {
		final float[] strength = new float[h.xx().length];
		for (int at = 0; at < strength.length; at++) {
			final double xx = h.xx()[at], xy = h.xy()[at], yy = h.yy()[at];
			final double half = (xx - yy) / 2;
			strength[at] = (float) (Math.sqrt(half * half + xy * xy) - (xx + yy) / 2);
		}
		return new RidgeStrength(h.width(), strength, at -> along(h, at), strength);
	}

	private static int along(final Hessian h, final int at) {
		final double along = Math.atan2(2.0 * h.xy()[at], (double) h.xx()[at] - h.yy()[at]) / 2;
		return (int) Math.floorMod(Math.round(along / Math.PI * DIRECTIONS), DIRECTIONS);
	}

	/** @return the second derivative, per px² */
	float strength(final int at) {
		return strength[at];
	}

	/** @return all of {@link #strength(int)}; not to be changed */
	float[] strengths() {
		return strength;
	}

	/** @return the strength's noise, above 0 */
	float noise(final int at) {
		return noise[at];
	}

	/** @return strength over noise */
	float z(final int at) {
		return strength[at] / noise[at];
	}

	/** @return the direction along the line, 0 to below pi, from x towards y */
	double angle(final int at) {
		if (known[at] == 0)
			known[at] = (byte) (directions.applyAsInt(at) + 1);
		return Math.PI * (known[at] - 1) / DIRECTIONS;
	}

	int width() {
		return width;
	}

	/** The eight filters. */
	private static final class Bank {

		private final Hessian hessian;
		private final int width, height, reach, paddedWidth;
		private final float[] weights;
		private final float[] best;
		/** The second derivative across a direction: as it is, and its rows padded. */
		private final float[] across, padded;
		private final float[] sums;
		private final int[] from;
		private final RidgeNoise noise;
		private final WeightedRows weighted;
		private final RowMaximum strongest;

		Bank(final Hessian hessian, final double along) {
			this.hessian = hessian;
			width = hessian.width();
			height = hessian.height();
			reach = (int) Math.ceil(ImageTuning.ALONG_REACH * along);
			weights = Pixels.floats(SeparableFilter.gauss(2 * reach + 1, along));
			best = new float[width * height];
			paddedWidth = width + 2 * reach;
			across = new float[width * height];
			padded = new float[paddedWidth * height];
			sums = new float[width];
			strongest = new RowMaximum(width);
			weighted = new WeightedRows(width);
			from = new int[weights.length];
			noise = new RidgeNoise(width, height);
			Arrays.fill(best, Float.NEGATIVE_INFINITY);
		}

		RidgeStrength best() {
			for (int k = 0; k < DIRECTIONS; k++) {
				Cancellation.check();
				look(k);
			}
			final Responses responses = new Responses(hessian, weights);
			return new RidgeStrength(width, best, responses::strongest, noise.field());
		}

		private void look(final int k) {
			final Direction d = new Direction(k);
			d.across(hessian, across);
			for (int y = 0; y < height; y++)
				SeparableFilter.pad(across, y * width, width, reach, padded, y * paddedWidth);
			for (int y = 0; y < height; y++) {
				for (int i = -reach; i <= reach; i++)
					from[i + reach] = Math.min(Math.max(y + d.rows(i), 0), height - 1) * paddedWidth
						+ reach + d.columns(i);
				weighted.sum(padded, from, weights, sums);
				if (k % SAMPLED == 0 && y % RidgeNoise.STRIDE == 0)
					noise.add(y, sums, 0);
				strongest.raise(best, y * width, sums, 0, width);
			}
		}
	}

	/** One of the directions along a line. */
	private static final class Direction {

		private final double c, s;
		private final float mixed, alongX, alongY;

		Direction(final int k) {
			c = Math.cos(Math.PI * k / DIRECTIONS);
			s = Math.sin(Math.PI * k / DIRECTIONS);
			mixed = (float) (2 * s * c);
			alongX = (float) (s * s);
			alongY = (float) (c * c);
		}

		/** @return columns to the pixel that is so many steps on */
		int columns(final int steps) {
			return (int) Math.rint(steps * c);
		}

		/** @return rows to the pixel that is so many steps on */
		int rows(final int steps) {
			return (int) Math.rint(steps * s);
		}

		/** The negative second derivative across it, at every pixel. */
		void across(final Hessian h, final float[] out) {
			final float[] xx = h.xx(), xy = h.xy(), yy = h.yy();
			for (int at = 0; at < out.length; at++)
				out[at] = mixed * xy[at] - alongX * xx[at] - alongY * yy[at];
		}

		float across(final Hessian h, final int at) {
			return mixed * h.xy()[at] - alongX * h.xx()[at] - alongY * h.yy()[at];
		}
	}

	/** The responses of all filters at single pixels, as the bank has them. */
	private static final class Responses {

		private final Hessian hessian;
		private final float[] weights;
		private final Direction[] directions = new Direction[DIRECTIONS];

		Responses(final Hessian hessian, final float[] weights) {
			this.hessian = hessian;
			this.weights = weights;
			Arrays.setAll(directions, Direction::new);
		}

		int strongest(final int at) {
			int strongest = 0;
			float most = Float.NEGATIVE_INFINITY;
			for (int k = 0; k < DIRECTIONS; k++) {
				final float response = response(directions[k], at);
				if (response > most) {
					most = response;
					strongest = k;
				}
			}
			return strongest;
		}

		private float response(final Direction d, final int at) {
			final int width = hessian.width(), height = hessian.height();
			final int x = at % width, y = at / width, reach = weights.length / 2;
			float sum = 0;
			for (int i = -reach; i <= reach; i++) {
				final int u = Math.min(Math.max(x + d.columns(i), 0), width - 1);
				final int v = Math.min(Math.max(y + d.rows(i), 0), height - 1);
				sum += weights[i + reach] * d.across(hessian, v * width + u);
			}
			return sum;
		}
	}
}
