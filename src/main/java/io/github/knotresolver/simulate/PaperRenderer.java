
package io.github.knotresolver.simulate;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.UserException;

/**
 * The published rendering: a one-pixel skeleton, dilated by a diamond of size
 * 2, blurred by a 3x3 Gaussian of sigma 2, with Gaussian noise of a given
 * signal-to-noise ratio: noise power = variance of the noise-free frame /
 * 10^(SNR/10). The background is 10, the filament 200 (8 bit). The skeleton
 * rounds the truth to whole pixels. O(pixels + length) a frame.
 */
public final class PaperRenderer implements FrameRenderer {

	private static final double BACKGROUND = 10;
	private static final double PEAK = 200;
	private static final int DIAMOND = 2;
	private static final double SIGMA = 2;

	private final double snr;
	private final long seed;

	/**
	 * @param snr signal-to-noise ratio in dB, -30 to 100, or infinity for none
	 * @param seed start of the noise's random numbers
	 * @throws UserException if the ratio is out of range
	 */
	public PaperRenderer(final double snr, final long seed) {
		this.snr = snr == Double.POSITIVE_INFINITY
			? snr
			: Require.within("snr", snr, -30, 100, "dB");
		this.seed = seed;
	}

	@Override
	public double[] render(final Polyline curve, final int frame, final Canvas canvas,
		final BitDepth depth) {
		final int width = canvas.width();
		final double[] image = blurred(thickened(skeleton(curve, canvas), width), width);
		for (int i = 0; i < image.length; i++)
			image[i] = depth.scale() * (BACKGROUND + (PEAK - BACKGROUND) * image[i]);
		final double sd = Math.sqrt(variance(image) / StrictMath.pow(10, snr / 10));
		final Noise noise = Noise.ofFrame(seed, frame);
		if (sd > 0)
			for (int i = 0; i < image.length; i++)
				image[i] += sd * noise.gaussian();
		return image;
	}

	private static boolean[] skeleton(final Polyline curve, final Canvas canvas) {
		final boolean[] mask = new boolean[canvas.width() * canvas.height()];
		final Polyline q = curve.resampled(1);
		for (int i = 0; i < q.size() - 1; i++)
			line(mask, canvas, (int) Math.rint(q.x(i)), (int) Math.rint(q.y(i)),
				(int) Math.rint(q.x(i + 1)), (int) Math.rint(q.y(i + 1)));
		return mask;
	}

	/** Pixels of a line no longer than two pixels: its ends and its middle. */
	private static void line(final boolean[] mask, final Canvas canvas, final int x0, final int y0,
		final int x1, final int y1) {
		final int steps = Math.max(1, Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0)));
		for (int k = 0; k <= steps; k++) {
			final int x = (int) Math.rint(x0 + (double) k * (x1 - x0) / steps);
			final int y = (int) Math.rint(y0 + (double) k * (y1 - y0) / steps);
			if (x >= 0 && y >= 0 && x < canvas.width() && y < canvas.height())
				mask[y * canvas.width() + x] = true;
		}
	}

	private static boolean[] thickened(final boolean[] mask, final int width) {
		final boolean[] thick = new boolean[mask.length];
		final int height = mask.length / width;
		for (int i = 0; i < mask.length; i++)
			if (mask[i])
				stamp(thick, i % width, i / width, width, height);
		return thick;
	}

	private static void stamp(final boolean[] thick, final int x, final int y, final int width,
		final int height) {
		for (int dy = -DIAMOND; dy <= DIAMOND; dy++)
			for (int dx = Math.abs(dy) - DIAMOND; dx <= DIAMOND - Math.abs(dy); dx++)
				if (x + dx >= 0 && y + dy >= 0 && x + dx < width && y + dy < height)
					thick[(y + dy) * width + x + dx] = true;
	}

	private static double[] blurred(final boolean[] mask, final int width) {
		final double side = StrictMath.exp(-1 / (2 * SIGMA * SIGMA));
		final double total = (1 + 2 * side) * (1 + 2 * side);
		final int height = mask.length / width;
		final double[] blurred = new double[mask.length];
		for (int i = 0; i < mask.length; i++)
			if (mask[i])
				for (int dy = -1; dy <= 1; dy++)
					for (int dx = -1; dx <= 1; dx++) {
						final int x = i % width + dx, y = i / width + dy;
						if (x >= 0 && y >= 0 && x < width && y < height)
							blurred[y * width + x] += (dx == 0 ? 1 : side) * (dy == 0 ? 1 : side)
								/ total;
					}
		return blurred;
	}

	private static double variance(final double[] image) {
		double sum = 0, squares = 0;
		for (final double v : image)
			sum += v;
		final double mean = sum / image.length;
		for (final double v : image)
			squares += (v - mean) * (v - mean);
		return squares / image.length;
	}
}
