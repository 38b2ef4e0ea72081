package io.github.knotresolver.evaluate.like;

import java.util.SplittableRandom;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.simulate.BitDepth;
import io.github.knotresolver.simulate.Canvas;
import io.github.knotresolver.simulate.FrameRenderer;
import io.github.knotresolver.simulate.LightField;

/**
 * Draws a simulated filament into the user's own movie, from which the filament
 * was taken out: with the line's profile and brightness, and with the noise
 * that its light adds.
 */
final class LikeRenderer implements FrameRenderer {

	/** Uniform numbers whose sum is a Gaussian one: of variance 1. */
	private static final int SUMMANDS = 12;

	private final Backdrop backdrop;
	private final Appearance look;
	private final Point fixedEnd;
	private final long seed;

	/**
	 * @param backdrop what is drawn into
	 * @param look of the line
	 * @param fixedEnd of the user's filament, in pixels
	 * @param seed start of the random numbers
	 */
	LikeRenderer(final Backdrop backdrop, final Appearance look, final Point fixedEnd,
		final long seed) {
		this.backdrop = backdrop;
		this.look = look;
		this.fixedEnd = fixedEnd;
		this.seed = seed;
	}

	@Override
	public double[] render(final Polyline curve, final int frame, final Canvas canvas,
		final BitDepth depth) {
		final int width = canvas.width(), height = canvas.height();
		final double[] image = backdrop.view(frame, width, height, fixedEnd,
			new Point(canvas.offsetX(), canvas.offsetY()), (seed & 1) != 0, (seed & 2) != 0);
		final double[] core = light(curve, width, height, look.profile().core(),
			look.profile().coreSigma());
		final double[] halo = light(curve, width, height, look.profile().halo(),
			look.profile().haloSigma());
		final SplittableRandom random = new SplittableRandom(seed * 0x9E3779B97F4A7C15L + frame);
		for (int i = 0; i < image.length; i++) {
			final double above = Math.min(look.ceiling(), core[i] + halo[i]);
			final double noise = gaussian(random) * Math.sqrt(look.shotVariance(above));
			image[i] = look.range().drawn(Math.min(brightest(), image[i] + above + noise));
		}
		return image;
	}

	private double brightest() {
		return look.range().clipped() ? look.range().highest() : Double.POSITIVE_INFINITY;
	}

	/** The line in pieces, each with its own brightness. */
	private double[] light(final Polyline curve, final int width, final int height,
		final double brightness, final double sigma) {
		final LightField field = new LightField(width, height, sigma);
		final double[] along = look.along();
		final Polyline fine = curve.resampled(0.5);
		for (int k = 0; k < along.length; k++) {
			final double from = fine.length() * k / along.length;
			final double to = fine.length() * (k + 1) / along.length;
			final Polyline rest = fine.reversed().head(fine.length() - from).reversed();
			field.addLine(rest.head(to - from), brightness * along[k]);
		}
		return field.values();
	}

	/** Additions alone: the same on every machine. */
	private static double gaussian(final SplittableRandom random) {
		double sum = -SUMMANDS / 2.0;
		for (int i = 0; i < SUMMANDS; i++)
			sum += random.nextDouble();
		return sum;
	}
}
