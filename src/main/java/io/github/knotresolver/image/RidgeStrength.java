package io.github.knotresolver.image;

import java.util.Arrays;

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

	/** The average along the line is a Gaussian of this many standard deviations of the filter. */
	private static final double ALONG = 1.5;

	/** The average ends at so many of its own standard deviations. */
	private static final double REACH = 2;

	/** Every third direction is a sample of the noise. */
	private static final int SAMPLED = 3;

	private final int width;
	private final float[] strength, noise;
	private final byte[] direction;

	private RidgeStrength(final int width, final float[] strength, final byte[] direction,
		final float[] noise) {
		this.width = width;
		this.strength = strength;
		this.direction = direction;
		this.noise = noise;
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
		return new Bank(hessian, ALONG * sigma).best();
	}

	/** @return the response of one of the filters alone, at every pixel */
	static float[] inDirection(final Hessian hessian, final double sigma, final int direction) {
		final Bank bank = new Bank(hessian, ALONG * sigma);
		bank.look(direction);
		return bank.best;
	}

	/** Without the average along: the principal curvature at every pixel; its noise is not known. */
	static RidgeStrength principal(final Hessian h) {
		final float[] strength = new float[h.xx().length];
		final byte[] direction = new byte[strength.length];
		for (int at = 0; at < strength.length; at++) {
			final double xx = h.xx()[at], xy = h.xy()[at], yy = h.yy()[at];
			strength[at] = (float) (Math.hypot((xx - yy) / 2, xy) - (xx + yy) / 2);
			final double along = Math.atan2(2 * xy, xx - yy) / 2;
			direction[at] = (byte) Math.floorMod(Math.round(along / Math.PI * DIRECTIONS),
				DIRECTIONS);
		}
		return new RidgeStrength(h.width(), strength, direction, strength);
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
		return Math.PI * direction[at] / DIRECTIONS;
	}

	int width() {
		return width;
	}

	/** The eight filters. */
	private static final class Bank {

		private final Hessian hessian;
		private final int width, height, reach;
		private final float[] weights;
		private final float[] best;
		private final byte[] argument;
		private final float[] padded, rows, sums;
		private final RidgeNoise noise;

		Bank(final Hessian hessian, final double along) {
			this.hessian = hessian;
			width = hessian.width();
			height = hessian.height();
			reach = (int) Math.ceil(REACH * along);
			weights = weights(reach, along);
			best = new float[width * height];
			argument = new byte[width * height];
			padded = new float[width + 2 * reach];
			rows = new float[padded.length * height];
			sums = new float[width];
			noise = new RidgeNoise(width, height);
			Arrays.fill(best, Float.NEGATIVE_INFINITY);
		}

		private static float[] weights(final int reach, final double sigma) {
			final double[] gauss = SeparableFilter.gauss(2 * reach + 1, sigma);
			final float[] weights = new float[gauss.length];
			for (int i = 0; i < weights.length; i++)
				weights[i] = (float) gauss[i];
			return weights;
		}

		RidgeStrength best() {
			for (int k = 0; k < DIRECTIONS; k++) {
				Cancellation.check();
				look(k);
			}
			return new RidgeStrength(width, best, argument, noise.field());
		}

		private void look(final int k) {
			final double c = Math.cos(Math.PI * k / DIRECTIONS);
			final double s = Math.sin(Math.PI * k / DIRECTIONS);
			across((float) (2 * s * c), (float) (s * s), (float) (c * c));
			for (int y = 0; y < height; y++) {
				along(y, c, s);
				if (k % SAMPLED == 0 && y % RidgeNoise.STRIDE == 0)
					noise.add(y, sums, 0);
				for (int x = 0, at = y * width; x < width; x++, at++)
					if (sums[x] > best[at]) {
						best[at] = sums[x];
						argument[at] = (byte) k;
					}
			}
		}

		/** The negative second derivative across the direction, its rows padded. */
		private void across(final float mixed, final float alongX, final float alongY) {
			for (int y = 0; y < height; y++) {
				final int row = y * width;
				for (int x = 0; x < width; x++)
					sums[x] = mixed * hessian.xy()[row + x] - alongX * hessian.xx()[row + x]
						- alongY * hessian.yy()[row + x];
				SeparableFilter.pad(sums, 0, width, reach, padded);
				System.arraycopy(padded, 0, rows, y * padded.length, padded.length);
			}
		}

		private void along(final int y, final double c, final double s) {
			Arrays.fill(sums, 0);
			for (int i = -reach; i <= reach; i++) {
				final int v = Math.min(Math.max(y + (int) Math.rint(i * s), 0), height - 1);
				SeparableFilter.add(rows, v * padded.length + reach + (int) Math.rint(i * c),
					weights[i + reach], sums);
			}
		}
	}
}
