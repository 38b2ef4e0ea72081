
package io.github.knotresolver.skeleton;

import java.util.function.IntPredicate;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;

/** Sorts the pixels of a line by how many neighbours they have. */
final class NeighbourCount {

	private NeighbourCount() {
	}

	/** @return the pixels of the skeleton whose number of neighbours fits */
	static Img<BitType> select(final RandomAccessibleInterval<BitType> skeleton,
		final IntPredicate fits) {
		final Neighbourhood line = new Neighbourhood(skeleton);
		final boolean[] selected = new boolean[line.toBits().length];
		for (final int at : line.pixels())
			selected[line.inside(at)] = fits.test(Integer.bitCount(line.around(at)));
		return Pixels.mask(selected, line.width());
	}
}
