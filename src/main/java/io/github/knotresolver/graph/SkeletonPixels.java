
package io.github.knotresolver.graph;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.skeleton.SkeletonNodes;

/**
 * The pixels of a skeleton in scan order, with their branch rule. A pixel is
 * named by its index y * width + x.
 */
final class SkeletonPixels {

	private static final int[] DX = {-1, 0, 1, -1, 1, -1, 0, 1};
	private static final int[] DY = {-1, -1, -1, 0, 0, 1, 1, 1};

	private final int width;
	private final int height;
	private final boolean[] set;
	private final boolean[] branch;

	SkeletonPixels(final RandomAccessibleInterval<BitType> skeleton) {
		if (skeleton.numDimensions() != 2)
			throw new IllegalArgumentException(
				"A skeleton has two dimensions, x and y, but this one has "
					+ skeleton.numDimensions() + ".");
		width = (int) skeleton.dimension(0);
		height = (int) skeleton.dimension(1);
		set = Pixels.bits(skeleton);
		branch = Pixels.bits(SkeletonNodes.branches(skeleton));
	}

	int x(final int pixel) {
		return pixel % width;
	}

	int y(final int pixel) {
		return pixel / width;
	}

	/** The skeleton's pixels that are branch pixels, or those that are not. */
	boolean[] part(final boolean branches) {
		final boolean[] part = new boolean[set.length];
		for (int i = 0; i < set.length; i++)
			part[i] = set[i] && branch[i] == branches;
		return part;
	}

	/** The 8-neighbours of a pixel within a set of pixels, in scan order. */
	List<Integer> neighbours(final int pixel, final boolean[] within) {
		final List<Integer> found = new ArrayList<>(4);
		for (int k = 0; k < DX.length; k++) {
			final int nx = x(pixel) + DX[k], ny = y(pixel) + DY[k];
			if (nx >= 0 && ny >= 0 && nx < width && ny < height && within[ny * width + nx])
				found.add(ny * width + nx);
		}
		return found;
	}

	/** The 8-connected components of a set of pixels, each in scan order. */
	List<List<Integer>> components(final boolean[] within) {
		final boolean[] open = within.clone();
		final List<List<Integer>> components = new ArrayList<>();
		for (int i = 0; i < open.length; i++)
			if (open[i])
				components.add(flood(i, open));
		return components;
	}

	private List<Integer> flood(final int seed, final boolean[] open) {
		final List<Integer> component = new ArrayList<>();
		final ArrayDeque<Integer> queue = new ArrayDeque<>(List.of(seed));
		open[seed] = false;
		while (!queue.isEmpty()) {
			final int pixel = queue.remove();
			component.add(pixel);
			for (final int n : neighbours(pixel, open)) {
				open[n] = false;
				queue.add(n);
			}
		}
		component.sort(null);
		return component;
	}
}
