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
		final ConnectedComponents objects = ConnectedComponents.of(generous);
		final int[] shared = objects.overlap(strict);
		return objects.mask(object -> shared[object.label()] > 0);
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
		return MaskRepair.fillPinHoles(hysteresis(Pixels.mask(ridges.candidates(), ridges.width()),
			Pixels.mask(sure, ridges.width())), (int) (t * t));
	}
}
