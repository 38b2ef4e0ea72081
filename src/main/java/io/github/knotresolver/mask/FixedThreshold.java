package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.image.Pixels;

/** Pixels above a given intensity. */
public final class FixedThreshold implements Thresholder {

	private final double level;

	/**
	 * @param level the intensity, 0..1
	 */
	public FixedThreshold(final double level) {
		if (!(level >= 0 && level <= 1))
			throw new IllegalArgumentException(
				"threshold must be from 0 to 1, but is " + level + ".");
		this.level = level;
	}

	@Override
	public Seed seed(final RandomAccessibleInterval<FloatType> frame) {
		return new Seed(frame, above(frame, level));
	}

	/**
	 * Marks the pixels that are brighter than a level.
	 *
	 * @implNote op names="knotresolver.threshold"
	 * @param frame a frame
	 * @param level an intensity
	 * @return a new mask of the same size: the pixels above it; a pixel without a
	 *         value (NaN) counts as the lowest
	 */
	public static Img<BitType> above(final RandomAccessibleInterval<FloatType> frame,
		final double level) {
		final float[] values = Pixels.floats(frame);
		final boolean[] above = new boolean[values.length];
		for (int i = 0; i < values.length; i++)
			above[i] = values[i] > level;
		return Pixels.mask(above, Pixels.width(frame));
	}
}
