package io.github.knotresolver.ui;

import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.Roi;
import ij.plugin.frame.RoiManager;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ResultDisplay;

/** The way from a number to its picture: a frame of an open image, and a filament in it. */
public final class ShownFrame {

	private ShownFrame() {
	}

	/**
	 * Shows a frame, with the filament's contour selected if it is in the ROI Manager; an open review
	 * goes there, too.
	 *
	 * @param image an image with a window; may be null
	 * @param filament number of the filament, from 1
	 * @param frame from 1
	 * @return whether the image is there to be seen
	 */
	public static boolean goTo(final ImagePlus image, final int filament, final int frame) {
		if (image == null || image.getWindow() == null)
			return false;
		if (ReviewWindow.goTo(image, filament, frame))
			return true;
		ImageLink.goTo(image, image.getC(), frame);
		final RoiManager manager = RoiManager.getInstance2();
		final Optional<Roi> contour = manager == null
			? Optional.empty()
			: ResultDisplay.find(manager, image, filament, frame);
		contour.ifPresent(roi -> image.setRoi((Roi) roi.clone()));
		return true;
	}

	/**
	 * @param file a movie's file
	 * @return the image that it was opened as, if it is open in a window
	 */
	public static Optional<ImagePlus> image(final Path file) {
		return images().filter(i -> ImageFile.of(i).filter(file::equals).isPresent()).findFirst();
	}

	/** All images in windows. */
	static Stream<ImagePlus> images() {
		final int[] ids = WindowManager.getIDList();
		return ids == null
			? Stream.empty()
			: IntStream.of(ids).mapToObj(WindowManager::getImage)
				.filter(i -> i != null && i.getWindow() != null && i.getCanvas() != null);
	}
}
