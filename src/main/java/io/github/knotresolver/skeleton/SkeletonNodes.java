package io.github.knotresolver.skeleton;

import java.util.function.IntPredicate;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;

/** Where lines meet and where they end. */
public final class SkeletonNodes {

	private SkeletonNodes() {
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
	public static Img<BitType> branches(final RandomAccessibleInterval<BitType> skeleton) {
		return select(skeleton, neighbours -> neighbours >= 3);
	}

	/**
	 * A pixel of the skeleton is an end if exactly one of its eight neighbours is
	 * in the skeleton as well. Beyond the border there is nothing. O(n).
	 *
	 * @implNote op names="knotresolver.endPixels"
	 * @param skeleton lines one pixel wide
	 * @return a new mask of the same size: the end pixels
	 */
	public static Img<BitType> ends(final RandomAccessibleInterval<BitType> skeleton) {
		return select(skeleton, neighbours -> neighbours == 1);
	}

	/** The pixels of the skeleton whose number of neighbours fits. */
	private static Img<BitType> select(final RandomAccessibleInterval<BitType> skeleton,
		final IntPredicate fits) {
		final Neighbourhood line = new Neighbourhood(skeleton);
		final boolean[] selected = new boolean[line.toBits().length];
		for (final int at : line.pixels())
			selected[line.inside(at)] = fits.test(Integer.bitCount(line.around(at)));
		return Pixels.mask(selected, line.width());
	}
}
