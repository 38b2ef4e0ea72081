package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

/**
 * Our choice: half way between what background and filament are like near each
 * pixel. Otsu's mask tells first which is which, then the mask so found does,
 * three rounds in all; {@link LocalContrast} makes the picture in which the
 * active contour moves. One threshold for the whole frame must either lose the
 * dim end of a filament or fill its loops, in which its own light glows; this
 * one does neither, and differs little from Otsu's where contrast is even.
 * <p>
 * Half way between two means, again and again: Ridler and Calvard 1978,
 * doi:10.1109/TSMC.1978.4310039; here with local means.
 */
public final class LocalThreshold implements Thresholder {

	/** Half the edge of the window in pixels: about a filament's width. */
	public static final int RADIUS = 5;

	@Override
	public Seed seed(final RandomAccessibleInterval<FloatType> frame) {
		Seed seed = new OtsuThreshold().seed(frame);
		for (int round = 0; round < MaskTuning.THRESHOLD_ROUNDS; round++)
			seed = refined(frame, seed.mask());
		return seed;
	}

	private static Seed refined(final RandomAccessibleInterval<FloatType> frame,
		final RandomAccessibleInterval<BitType> mask) {
		final Img<FloatType> even = LocalContrast.normalize(frame,
			MaskRepair.removeSpecks(mask, FilamentSegmenter.SPECK), RADIUS);
		return new Seed(even, FixedThreshold.above(even, MaskTuning.HALF_WAY));
	}
}
