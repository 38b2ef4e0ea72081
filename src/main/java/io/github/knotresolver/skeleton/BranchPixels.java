
package io.github.knotresolver.skeleton;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

/** Where lines meet. */
public final class BranchPixels {

	private BranchPixels() {
	}

	/**
	 * The published rule: a pixel of the skeleton is a branch pixel if the sum
	 * over its 3x3 neighbourhood, itself included, is at least 4. Around one
	 * crossing there may be several. Beyond the border there is nothing. O(n).
	 *
	 * @implNote op names="knotresolver.branchPixels"
	 * @param skeleton lines one pixel wide
	 * @return a new mask of the same size: the branch pixels
	 */
	public static Img<BitType> of(final RandomAccessibleInterval<BitType> skeleton) {
		return NeighbourCount.select(skeleton, neighbours -> neighbours >= 3);
	}
}
