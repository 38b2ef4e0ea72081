package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.image.Ridges;

/** The mask of a frame's lines. */
public final class RidgeMask {

	private RidgeMask() {
	}

	/**
	 * Hysteresis: the objects of a generous mask that reach into a strict one, whole. O(n).
	 * <p>
	 * Canny 1986, doi:10.1109/TPAMI.1986.4767851.
	 *
	 * @implNote op names="knotresolver.hysteresis"
	 * @param generous a mask
	 * @param strict a mask of the same size
	 * @return a new mask: the 8-connected objects of the first with a pixel of the second
	 */
	public static Img<BitType> hysteresis(final RandomAccessibleInterval<BitType> generous,
		final RandomAccessibleInterval<BitType> strict) {
		Masks.requireSize(Pixels.width(generous), Pixels.height(generous), strict);
		final boolean[] bits = Pixels.bits(generous);
		hysteresis(bits, Pixels.bits(strict), Pixels.width(generous));
		return Pixels.mask(bits, Pixels.width(generous));
	}

	/** Takes objects without a pixel of the other mask out of a mask. */
	private static void hysteresis(final boolean[] bits, final boolean[] strict, final int width) {
		final int[] places = new int[bits.length];
		final boolean[] kept = new boolean[bits.length];
		for (int at = 0; at < bits.length; at++)
			if (strict[at] && bits[at] && !kept[at])
				spread(bits, width, at, kept, places);
		System.arraycopy(kept, 0, bits, 0, bits.length);
	}

	private static void spread(final boolean[] bits, final int width, final int start,
		final boolean[] kept, final int[] places) {
		final int height = bits.length / width;
		int top = 0;
		places[top++] = start;
		kept[start] = true;
		while (top > 0) {
			final int at = places[--top], x = at % width, y = at / width;
			for (int v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); v++)
				for (int u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); u++) {
					final int beside = v * width + u;
					if (!bits[beside] || kept[beside])
						continue;
					kept[beside] = true;
					places[top++] = beside;
				}
		}
	}

	/**
	 * What is a line beyond doubt somewhere, as far as it can be followed, without pin
	 * holes.
	 *
	 * @param ridges a frame's ridges
	 * @return a mask in working pixels
	 */
	public static Img<BitType> of(final Ridges ridges) {
		final boolean[] sure = new boolean[ridges.width() * ridges.height()];
		for (int at = 0; at < sure.length; at++)
			sure[at] = ridges.isSure(at);
		final double t = ridges.appearance().blurredSigma();
		final boolean[] lines = ridges.candidates();
		hysteresis(lines, sure, ridges.width());
		MaskRepair.fillPinHoles(lines, ridges.width(), (int) (t * t));
		return Pixels.mask(lines, ridges.width());
	}
}
