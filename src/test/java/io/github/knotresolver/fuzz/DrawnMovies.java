package io.github.knotresolver.fuzz;

import java.util.Random;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileSaver;
import ij.process.FloatProcessor;
import ij.process.ImageProcessor;

/** Small movies of all kinds: of filaments, of anything else, and of nothing. */
public final class DrawnMovies {

	/** What is in the picture. */
	private enum Content {
		WAVE, KNOT, TWO, SPECKS, CONSTANT, GRADIENT, BORDER, NOISE, NOT_A_NUMBER, HUGE
	}

	private record Drawing(Content content, int width, int height, int frames, int bits,
		double noise, boolean dark, long seed) {
	}

	private DrawnMovies() {
	}

	/** @return movies as the bytes of a TIFF file */
	public static Arbitrary<byte[]> any() {
		final Arbitrary<Content> contents = Arbitraries.frequencyOf(
			Tuple.of(8, Arbitraries.of(Content.WAVE, Content.KNOT, Content.TWO)),
			Tuple.of(3, Arbitraries.of(Content.class)));
		return Combinators.combine(contents, Arbitraries.of(1, 17, 40, 56, 64, 64, 72, 72, 80, 80),
			Arbitraries.of(3, 33, 48, 56, 56, 64, 64, 72, 72),
			Arbitraries.of(1, 2, 2, 3, 3, 4, 4, 5, 5, 6), Arbitraries.of(8, 8, 16, 16, 32, 24),
			Arbitraries.of(0.0, 0.02, 0.1, 0.5), Arbitraries.of(false, false, true),
			Arbitraries.longs()).as(Drawing::new).map(d -> new FileSaver(image(d)).serialize());
	}

	private static ImagePlus image(final Drawing d) {
		final Random random = new Random(d.seed);
		final double phase = 6 * random.nextDouble(), size = 0.3 + 0.6 * random.nextDouble();
		final ImageStack stack = new ImageStack(d.width, d.height);
		for (int t = 0; t < d.frames; t++) {
			final float[] pixels = new float[d.width * d.height];
			draw(d, pixels, phase + 0.3 * t, size, random);
			for (int i = 0; i < pixels.length; i++) {
				pixels[i] = 40 + 120 * (pixels[i] + (float) (d.noise * random.nextGaussian()));
				if (d.dark)
					pixels[i] = 200 - pixels[i];
			}
			stack.addSlice(converted(new FloatProcessor(d.width, d.height, pixels), d.bits));
		}
		final ImagePlus image = new ImagePlus("drawn", stack);
		image.setDimensions(1, 1, d.frames);
		image.setOpenAsHyperStack(d.frames > 1);
		return image;
	}

	private static ImageProcessor converted(final FloatProcessor p, final int bits) {
		p.setMinAndMax(0, 255);
		return switch (bits) {
			case 8 -> p.convertToByteProcessor(false);
			case 16 -> p.convertToShortProcessor(false);
			case 24 -> p.convertToByteProcessor(false).convertToRGB();
			default -> p;
		};
	}

	private static void draw(final Drawing d, final float[] pixels, final double phase,
		final double size, final Random random) {
		switch (d.content) {
			case WAVE -> curve(d, pixels, phase, size, 0.5);
			case KNOT -> curve(d, pixels, phase, size, 3.5);
			case TWO -> {
				curve(d, pixels, phase, size, 0.5);
				curve(d, pixels, -phase, 0.8 * size, 2);
			}
			case SPECKS -> {
				for (int i = 0; i < 9; i++)
					pixels[random.nextInt(pixels.length)] = 1;
			}
			case BORDER -> {
				for (int i = 0; i < d.width; i++)
					pixels[i] = 1;
			}
			case GRADIENT -> {
				for (int i = 0; i < pixels.length; i++)
					pixels[i] = (float) (i % d.width) / d.width;
			}
			case NOISE -> {
				for (int i = 0; i < pixels.length; i++)
					pixels[i] = random.nextFloat();
			}
			case NOT_A_NUMBER -> {
				curve(d, pixels, phase, size, 1);
				pixels[random.nextInt(pixels.length)] = Float.NaN;
				pixels[random.nextInt(pixels.length)] = Float.POSITIVE_INFINITY;
			}
			case HUGE -> {
				curve(d, pixels, phase, size, 1);
				for (int i = 0; i < pixels.length; i++)
					pixels[i] *= 1e36f;
			}
			default -> {
			}
		}
	}

	/** A line about 3 px wide whose direction swings. */
	private static void curve(final Drawing d, final float[] pixels, final double phase,
		final double size, final double swing) {
		final double length = 1.6 * size * Math.max(d.width, d.height);
		double x = 0.15 * d.width, y = 0.5 * d.height;
		for (double s = 0; s < length; s += 0.5) {
			final double angle = swing * Math.sin(5 * s / length + phase) * s / length;
			x += 0.5 * Math.cos(angle);
			y += 0.5 * Math.sin(angle);
			for (int py = (int) y - 2; py <= y + 3; py++)
				for (int px = (int) x - 2; px <= x + 3; px++)
					if (px >= 0 && py >= 0 && px < d.width && py < d.height)
						pixels[py * d.width + px] = (float) Math.max(pixels[py * d.width + px],
							Math.exp(-((px - x) * (px - x) + (py - y) * (py - y)) / 4));
		}
	}
}
