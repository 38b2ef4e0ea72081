package io.github.knotresolver.ui;

import java.awt.event.MouseEvent;
import java.awt.event.MouseListener;
import java.awt.event.MouseMotionListener;
import java.util.Optional;
import java.util.function.Consumer;

import javax.swing.SwingUtilities;

import ij.ImageListener;
import ij.ImagePlus;
import ij.gui.ImageCanvas;
import ij.gui.Overlay;
import io.github.knotresolver.geometry.Drag;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.ReviewPictures;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.ui.model.ReviewModel;

/**
 * ImageJ's image under review: it shows the frame with its contour, and its slider and mouse are
 * heard. Where the mouse is pressed on the contour, the contour is dragged; everywhere else ImageJ's
 * tools work as ever.
 */
final class ImageLink implements ImageListener, MouseListener, MouseMotionListener, AutoCloseable {

	/** Screen pixels within which the contour is caught. */
	private static final double REACH = 8;

	/** From a pixel's corner, where ImageJ's canvas counts from, to its centre. */
	private static final double HALF = 0.5;

	private final ImagePlus image;
	private final int channel;
	private final ReviewModel model;
	private final Runnable closed;
	private final ImageCanvas canvas;
	private final MouseListener[] mouse;
	private final MouseMotionListener[] motion;
	private final Overlay before;
	private Optional<Drag> drag = Optional.empty();
	private boolean showing;
	/** The model's frame when the image was made to follow it last. */
	private int followed;

	/**
	 * @param image shown in a window
	 * @param channel that was resolved, from 1
	 * @param model what is shown
	 * @param closed called when the image is closed
	 */
	ImageLink(final ImagePlus image, final int channel, final ReviewModel model,
		final Runnable closed) {
		this.image = image;
		this.channel = channel;
		this.model = model;
		this.closed = closed;
		canvas = image.getCanvas();
		before = image.getOverlay();
		// ImageJ's own come after this one, so that a drag is not a selection, too.
		mouse = canvas.getMouseListeners();
		motion = canvas.getMouseMotionListeners();
		for (final MouseListener l : mouse)
			canvas.removeMouseListener(l);
		for (final MouseMotionListener l : motion)
			canvas.removeMouseMotionListener(l);
		canvas.addMouseListener(this);
		canvas.addMouseMotionListener(this);
		ImagePlus.addImageListener(this);
	}

	/** Shows the model's frame and contour, and a dashed one. */
	void show(final Optional<Polyline> dashed) {
		showing = true;
		try {
			// The slider may be ahead of what is known here: the image follows the model's steps alone.
			final int wanted = model.frame();
			if (wanted != followed && frame(image) != wanted)
				goTo(image, channel, wanted);
			followed = wanted;
			final Overlay overlay = model
				.shown().flatMap(Observation::contour).map(c -> ReviewPictures
					.overlay(model.tracks().orElseThrow(), model.track().orElseThrow(), c))
				.orElseGet(Overlay::new);
			model.track().ifPresent(t -> ReviewPictures
				.others(model.tracks().orElseThrow(), t, model.frame()).forEach(overlay::add));
			dashed.ifPresent(c -> overlay.add(ReviewPictures.dashed(c)));
			image.setOverlay(overlay);
		} finally {
			showing = false;
		}
	}

	private static boolean isAlongZ(final ImagePlus image) {
		return image.getNFrames() == 1 && image.getNSlices() > 1;
	}

	/** @return the frame that an image shows, from 1, wherever its time runs */
	static int frame(final ImagePlus image) {
		return ImageMovie.isAlongChannels(image)
			? image.getC()
			: isAlongZ(image) ? image.getZ() : image.getT();
	}

	/** Shows a frame, wherever the image's time runs, and a channel if there are several. */
	static void goTo(final ImagePlus image, final int channel, final int frame) {
		if (image.getNChannels() == 1)
			image.setSlice(frame);
		else if (ImageMovie.isAlongChannels(image))
			image.setPosition(frame, 1, 1);
		else if (isAlongZ(image))
			image.setPosition(channel, frame, 1);
		else
			image.setPosition(channel, 1, frame);
	}

	@Override
	public void imageOpened(final ImagePlus other) {
		// Of no interest.
	}

	@Override
	public void imageClosed(final ImagePlus other) {
		if (other == image)
			SwingUtilities.invokeLater(closed);
	}

	@Override
	public void imageUpdated(final ImagePlus other) {
		if (other == image && !showing)
			model.goTo(frame(image));
	}

	private Point place(final MouseEvent e) {
		return new Point(canvas.offScreenXD(e.getX()) - HALF, canvas.offScreenYD(e.getY()) - HALF);
	}

	@Override
	public void mousePressed(final MouseEvent e) {
		drag = e.getButton() == MouseEvent.BUTTON1 && !e.isControlDown()
			? model.shown().flatMap(Observation::contour)
				.flatMap(c -> Drag.at(c, place(e), REACH / canvas.getMagnification()))
			: Optional.empty();
		if (drag.isEmpty())
			each(l -> l.mousePressed(e));
	}

	@Override
	public void mouseDragged(final MouseEvent e) {
		if (drag.isPresent())
			show(Optional.of(drag.get().to(place(e))));
		else
			for (final MouseMotionListener l : motion)
				l.mouseDragged(e);
	}

	@Override
	public void mouseReleased(final MouseEvent e) {
		if (drag.isEmpty()) {
			each(l -> l.mouseReleased(e));
			return;
		}
		final Drag done = drag.get();
		drag = Optional.empty();
		final Point place = place(e);
		if (done.contour().at(done.held()).distanceTo(place) * canvas.getMagnification() < REACH
			/ 2)
			show(Optional.empty());
		else
			model.drag(done, place);
	}

	@Override
	public void mouseClicked(final MouseEvent e) {
		each(l -> l.mouseClicked(e));
	}

	@Override
	public void mouseEntered(final MouseEvent e) {
		each(l -> l.mouseEntered(e));
	}

	@Override
	public void mouseExited(final MouseEvent e) {
		each(l -> l.mouseExited(e));
	}

	@Override
	public void mouseMoved(final MouseEvent e) {
		for (final MouseMotionListener l : motion)
			l.mouseMoved(e);
	}

	private void each(final Consumer<MouseListener> event) {
		for (final MouseListener l : mouse)
			event.accept(l);
	}

	/** The image is as it was before. */
	@Override
	public void close() {
		ImagePlus.removeImageListener(this);
		canvas.removeMouseListener(this);
		canvas.removeMouseMotionListener(this);
		for (final MouseListener l : mouse)
			canvas.addMouseListener(l);
		for (final MouseMotionListener l : motion)
			canvas.addMouseMotionListener(l);
		image.setOverlay(before);
	}
}
