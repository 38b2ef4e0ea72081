package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.image.Pixels;

/** Makes a dim end as bright as the rest, and the glow in a loop dark. */
public final class LocalContrast {

	private LocalContrast() {
	}

	/**
	 * Rescales each pixel so that 0 is what the background and 1 what the filament
	 * is like near it. Both are means over a square window, taken over the pixels
	 * outside and inside a first mask. They may only lie between the means of the
	 * whole frame: a dim part of the filament lowers the 1 and a glowing background
	 * raises the 0, but a bright crossing does not make the single strands beside
	 * it look dim, and empty background does not make noise look bright. Where the
	 * two come close to each other, the frame's means are used. A mask that is
	 * empty or full, or not brighter than the rest, gives all 0.
	 * <p>
	 * Local means instead of global ones for region-based contours: Lankton and
	 * Tannenbaum 2008, doi:10.1109/TIP.2008.2004611. By summed-area tables, O(n)
	 * for any radius.
	 *
	 * @implNote op names="knotresolver.localContrast"
	 * @param frame a clean frame
	 * @param mask a first mask of the same size, such as that of Otsu
	 * @param radius half the edge of the window in pixels, at least 1
	 * @return a new image of the same size, 0..1
	 */
	public static Img<FloatType> normalize(final RandomAccessibleInterval<FloatType> frame,
		final RandomAccessibleInterval<BitType> mask, final int radius) {
		if (radius < 1)
			throw new IllegalArgumentException(
				"The radius of the window must be at least 1 pixel, but is " + radius + ".");
		Masks.requireSameSize(frame, mask);
		final float[] values = Pixels.floats(frame);
		final boolean[] inside = Pixels.bits(mask);
		final int width = Pixels.width(frame);
		final WindowMeans bright = new WindowMeans(values, inside, true, width);
		final WindowMeans dark = new WindowMeans(values, inside, false, width);
		final double least = MaskTuning.LEAST_CONTRAST * (bright.all() - dark.all());
		final float[] normalized = new float[values.length];
		for (int at = 0; at < values.length; at++) {
			final double high = lower(bright.all(), bright.around(at, radius));
			final double low = higher(dark.all(), dark.around(at, radius));
			normalized[at] = high - low > least
				? between(low, high, values[at])
				: between(dark.all(), bright.all(), values[at]);
		}
		return Pixels.image(normalized, width);
	}

	/** @return the value's place from low to high, 0..1; 0 if there is none */
	private static float between(final double low, final double high, final double value) {
		return high > low ? (float) Math.max(0, Math.min(1, (value - low) / (high - low))) : 0;
	}

	private static double lower(final double global, final double local) {
		return local < global ? local : global;
	}

	private static double higher(final double global, final double local) {
		return local > global ? local : global;
	}
}
