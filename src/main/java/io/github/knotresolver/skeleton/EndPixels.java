
package io.github.knotresolver.skeleton;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

/** Where lines end. */
public final class EndPixels {

	private EndPixels() {
	}

	/**
	 * A pixel of the skeleton is an end if exactly one of its eight neighbours is
	 * in the skeleton as well. Beyond the border there is nothing. O(n).
	 *
	 * @implNote op names="knotresolver.endPixels"
	 * @param skeleton lines one pixel wide
	 * @return a new mask of the same size: the end pixels
	 */
	public static Img<BitType> of(final RandomAccessibleInterval<BitType> skeleton) {
		return NeighbourCount.select(skeleton, neighbours -> neighbours == 1);
	}
}
