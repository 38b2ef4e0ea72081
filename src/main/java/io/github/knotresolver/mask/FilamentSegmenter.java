
package io.github.knotresolver.mask;

import java.util.ArrayList;
import java.util.List;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.progress.Progress;

/**
 * Finds the masks of all objects in a clean frame: threshold, active contour,
 * then specks and pin holes are taken out. Has no state that changes, so frames
 * can be worked on in parallel.
 */
public final class FilamentSegmenter {

	/** Holes up to this many pixels are noise; a loop's hole is larger. */
	public static final int PIN_HOLE = 6;

	/** Objects below this many pixels are noise; a filament is larger. */
	public static final int SPECK = 12;

	private final Segmentation segmentation;
	private final Thresholder thresholder;

	/**
	 * The published method: Otsu's threshold unless one is given.
	 *
	 * @param segmentation the parameters
	 */
	public FilamentSegmenter(final Segmentation segmentation) {
		this(segmentation, new OtsuThreshold());
	}

	/**
	 * @param segmentation the parameters
	 * @param automatic what to do if they give no threshold
	 */
	public FilamentSegmenter(final Segmentation segmentation, final Thresholder automatic) {
		this.segmentation = segmentation;
		this.thresholder = segmentation.threshold().isPresent()
			? new FixedThreshold(segmentation.threshold().getAsDouble())
			: automatic;
	}

	/**
	 * @param frame a clean frame
	 * @return a mask of the same size with all objects
	 */
	public Img<BitType> segment(final RandomAccessibleInterval<FloatType> frame) {
		final Thresholder.Seed seed = thresholder.seed(frame);
		return segmentFrom(seed.frame(), seed.mask());
	}

	/**
	 * Starts from a given mask instead of the threshold's.
	 *
	 * @param frame a clean frame
	 * @param seed a mask of the same size, for instance that of the last frame
	 * @return a mask of the same size with all objects
	 */
	public Img<BitType> segmentFrom(final RandomAccessibleInterval<FloatType> frame,
		final RandomAccessibleInterval<BitType> seed) {
		final Img<BitType> mask = ChanVese.evolve(frame, seed, iterations(),
			segmentation.contractionBias(), segmentation.smoothFactor());
		return MaskRepair.fillPinHoles(MaskRepair.removeSpecks(mask, SPECK), PIN_HOLE);
	}

	/**
	 * A baseline of the paper: only the first frame is thresholded, and each other
	 * frame's contour starts from the mask of the frame before. It loses filaments
	 * that move by more than the contour can follow.
	 *
	 * @param frames clean frames in order, all of the same size
	 * @param progress is told how far it is and may cancel
	 * @return for each frame a mask with all objects; empty masks once the contour
	 *         has vanished
	 */
	public List<Img<BitType>> segmentByContourAlone(
		final List<? extends RandomAccessibleInterval<FloatType>> frames, final Progress progress) {
		final List<Img<BitType>> masks = new ArrayList<>(frames.size());
		for (final RandomAccessibleInterval<FloatType> frame : frames) {
			progress.checkCancelled();
			masks.add(
				masks.isEmpty() ? segment(frame) : segmentFrom(frame, masks.get(masks.size() - 1)));
			progress.report("Moving contours", masks.size() / (double) frames.size());
		}
		return masks;
	}

	private int iterations() {
		return segmentation.steps() == Segmentation.Steps.THRESHOLD ? 0 : segmentation.iterations();
	}
}
