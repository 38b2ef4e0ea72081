package io.github.knotresolver.imagej;

import java.io.File;

import ij.IJ;
import ij.ImagePlus;
import ij.plugin.filter.RankFilters;
import ij.process.ImageProcessor;

/**
 * What any analysis does at least: ImageJ reads a movie and takes a 3 x 3 median of each frame. A
 * movie of more than 1 GB is opened as a virtual stack.
 */
public final class MedianMain {

	private static final long LARGE = 1L << 30;

	private MedianMain() {
	}

	/** @param args a movie; its size is printed */
	public static void main(final String[] args) {
		final ImagePlus image = new File(args[0]).length() > LARGE
			? IJ.openVirtual(args[0])
			: IJ.openImage(args[0]);
		final RankFilters filters = new RankFilters();
		for (int n = 1; n <= image.getStackSize(); n++) {
			final ImageProcessor frame = image.getStack().getProcessor(n);
			filters.rank(frame, 1, RankFilters.MEDIAN);
		}
		System.out.println(image.getStackSize() + "×" + image.getWidth() + "×" + image.getHeight());
		// The threads of ImageJ's filters wait for ever for more to do.
		System.exit(0);
	}
}
