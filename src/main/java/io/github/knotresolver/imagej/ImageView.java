
package io.github.knotresolver.imagej;

import java.awt.EventQueue;
import java.awt.Rectangle;
import java.lang.reflect.InvocationTargetException;

import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.GUI;
import ij.gui.ImageCanvas;
import ij.gui.ImageWindow;
import io.github.knotresolver.model.Tracks;

/**
 * Windows of images: so large that one sees what is in them, and in front. An image without a
 * window, such as that of a macro in batch mode, stays as it is.
 */
public final class ImageView {

	/** A window takes this part of the screen's width or height. */
	private static final double SHARE = 0.6;

	/** What is shown larger than this part of the screen stays as the user has it. */
	private static final double LARGE = 0.35;

	/** Magnifications, as ImageJ's own, largest first. */
	private static final double[] MAGNIFICATIONS = {32, 24, 16, 12, 8, 6, 4, 3, 2, 1.5, 1};

	private ImageView() {
	}

	/**
	 * Shows an image in a window, magnified if it is small.
	 *
	 * @param image the image
	 */
	public static void show(final ImagePlus image) {
		image.show();
		onEventThread(() -> fill(image, new Rectangle(image.getWidth(), image.getHeight())));
	}

	/**
	 * Brings an image in front of all other windows, magnified so that the filament fills its
	 * window.
	 *
	 * @param image the image
	 * @param tracks what was found in it
	 */
	public static void front(final ImagePlus image, final Tracks tracks) {
		final Viewport part = Viewport.aroundContours(tracks.movie(), tracks.filaments());
		onEventThread(() -> {
			final ImageWindow window = image.getWindow();
			if (window == null || !window.isVisible())
				return;
			fill(image, new Rectangle(part.x(), part.y(), part.width(), part.height()));
			WindowManager.setCurrentWindow(window);
			window.toFront();
		});
	}

	private static void fill(final ImagePlus image, final Rectangle part) {
		final ImageWindow window = image.getWindow();
		if (window == null)
			return;
		final ImageCanvas canvas = window.getCanvas();
		final Rectangle screen = GUI.getMaxWindowBounds(window);
		final double one = Math.max((double) part.width / screen.width,
			(double) part.height / screen.height);
		final boolean seen = canvas.getSrcRect().contains(part);
		if (seen && one * canvas.getMagnification() > LARGE)
			return;
		for (final double magnification : MAGNIFICATIONS)
			if (one * magnification <= SHARE) {
				canvas.setSourceRect(part);
				canvas.setMagnification(magnification);
				canvas.setSize((int) (part.width * magnification),
					(int) (part.height * magnification));
				window.pack();
				canvas.repaint();
				return;
			}
	}

	/** Windows are changed by the thread that draws them. */
	static void onEventThread(final Runnable work) {
		if (EventQueue.isDispatchThread()) {
			work.run();
			return;
		}
		try {
			EventQueue.invokeAndWait(work);
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
		} catch (final InvocationTargetException e) {
			throw new IllegalStateException(e.getCause());
		}
	}
}
