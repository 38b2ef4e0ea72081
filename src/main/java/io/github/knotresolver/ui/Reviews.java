package io.github.knotresolver.ui;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

import ij.ImagePlus;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageView;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** The way from a result folder to its window, for all front doors. */
public final class Reviews {

	private Reviews() {
	}

	/**
	 * Opens a result folder for review, its movie in the image that is open already, or in a new one.
	 *
	 * @param folder a folder that {@code resolve} wrote
	 * @param here whether to begin at the frame that the image shows, else at the first
	 * @param progress may cancel
	 * @param closed called when the window has been closed
	 * @throws UserException if it cannot be reviewed, in one sentence
	 * @throws IOException if its files cannot be read
	 */
	public static void open(final Path folder, final boolean here, final Progress progress,
		final Runnable closed) throws IOException {
		requireDisplay();
		progress.report("Opening the result", 0);
		final ReviewedResult result = ReviewedResult.open(folder, progress);
		try {
			show(result, image(result, progress), here, closed);
		} catch (final RuntimeException | Error e) {
			result.close();
			throw e;
		}
	}

	/**
	 * Opens the result in memory of an image, or brings its review to the front.
	 *
	 * @param image an image; may be null
	 * @param here whether to begin at the frame that it shows, else at the first
	 * @param closed called when the window has been closed
	 * @return whether there is one
	 * @throws IOException if the files of its folder cannot be read
	 */
	public static boolean ofImage(final ImagePlus image, final boolean here, final Runnable closed)
		throws IOException {
		requireDisplay();
		if (ReviewWindow.toFront(image))
			return true;
		final Optional<LiveResult> live = LiveResult.of(image);
		if (live.isPresent())
			show(ReviewedResult.of(live.get(), image), image, here, closed);
		return live.isPresent();
	}

	private static void requireDisplay() {
		if (GraphicsEnvironment.isHeadless())
			throw new UserException(
				"A review needs a display; without one, give Resolve Filament... a file of corrections.");
	}

	private static void show(final ReviewedResult result, final ImagePlus image, final boolean here,
		final Runnable closed) {
		if (here)
			result.model().goTo(ImageLink.frame(image));
		if (ReviewWindow.toFront(image))
			throw new UserException("The movie of result " + result.name()
				+ " is being reviewed already; its window is in front now.");
		EventThread.run(() -> ReviewWindow.open(result, image, closed));
	}

	private static ImagePlus image(final ReviewedResult result, final Progress progress) {
		final Optional<ImagePlus> present = result.file().flatMap(ShownFrame::image);
		if (present.isPresent())
			return present.get();
		final ImagePlus image = ImageFile.open(result.file().orElseThrow(), progress);
		ImageView.show(image);
		return image;
	}
}
