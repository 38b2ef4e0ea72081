package io.github.knotresolver.mask;

import java.util.ArrayList;
import java.util.List;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.progress.Progress;

/**
 * A baseline of the paper: only the first frame is thresholded, and each other
 * frame's contour starts from the mask of the frame before. It loses filaments
 * that move by more than the contour can follow.
 */
public final class ActiveContourOnly {

	private ActiveContourOnly() {
	}

	/**
	 * @param frames clean frames in order, all of the same size
	 * @param segmenter thresholds the first frame and moves the contours
	 * @param progress is told how far it is and may cancel
	 * @return for each frame a mask with all objects; empty masks once the contour
	 *         has vanished
	 */
	public static List<Img<BitType>> segment(
		final List<? extends RandomAccessibleInterval<FloatType>> frames,
		final FilamentSegmenter segmenter, final Progress progress) {
		final List<Img<BitType>> masks = new ArrayList<>(frames.size());
		for (final RandomAccessibleInterval<FloatType> frame : frames) {
			progress.checkCancelled();
			masks.add(masks.isEmpty()
				? segmenter.segment(frame)
				: segmenter.segmentFrom(frame, masks.get(masks.size() - 1)));
			progress.report("Moving contours", masks.size() / (double) frames.size());
		}
		return masks;
	}
}
