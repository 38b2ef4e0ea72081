package io.github.knotresolver.imagej;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

import ij.ImagePlus;
import ij.gui.Overlay;
import ij.gui.Roi;
import ij.plugin.frame.RoiManager;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;

/** Shows a result in ImageJ. The pixels of the image stay as they are. */
public final class ResultDisplay {

	/** Pieces of one colour along a contour. */
	private static final int PIECES = 16;
	private static final int LINKS = 8;
	/** Which image a ROI in the manager belongs to. */
	private static final String OF_IMAGE = "knotresolver.image";

	private final ImagePlus image;
	private final Tracks tracks;
	private final RoiConverter converter;

	/**
	 * @param image the image that was resolved
	 * @param tracks the result
	 * @param rois makes ROIs for this image
	 */
	public ResultDisplay(final ImagePlus image, final Tracks tracks, final RoiConverter rois) {
		this.image = image;
		this.tracks = tracks;
		this.converter = rois;
	}

	/**
	 * Adds one polyline a frame, each at its frame's position and coloured by its
	 * confidence or, with several filaments, by its filament, in place of those of an earlier run on the same image.
	 *
	 * @param manager the ROI Manager
	 */
	public void fill(final RoiManager manager) {
		// The manager's list is a Swing component.
		ImageView.onEventThread(() -> {
			// The recorder shall not see what is a part of this Command.
			manager.allowRecording(false);
			try {
				removeEarlier(manager);
				rois().forEach(manager::addRoi);
			} finally {
				manager.allowRecording(true);
			}
		});
	}

	/**
	 * @param manager the ROI Manager
	 * @param image an image that was resolved
	 * @param filament number of a filament, from 1
	 * @param frame from 1
	 * @return the contour that {@link #fill} put there; empty if it is not there any more
	 */
	public static Optional<Roi> find(final RoiManager manager, final ImagePlus image,
		final int filament, final int frame) {
		for (final Roi roi : manager.getRoisAsArray())
			if (image.getTitle().equals(roi.getProperty(OF_IMAGE))
				&& RoiContours.filament(roi) == filament && RoiContours.frame(roi, image) == frame)
				return Optional.of(roi);
		return Optional.empty();
	}

	/**
	 * @param manager the ROI Manager
	 * @param image an image that was resolved
	 * @return its contours as they are in the manager now, where a person may have changed them
	 */
	public static List<Constraint> contours(final RoiManager manager, final ImagePlus image) {
		final List<Constraint> contours = new ArrayList<>();
		for (final Roi roi : manager.getRoisAsArray()) {
			final String owner = roi.getProperty(OF_IMAGE);
			final boolean ours = owner == null
				? roi.getName() != null && roi.getName().startsWith(RoiConverter.PREFIX)
				: owner.equals(image.getTitle());
			if (ours && RoiContours.isLine(roi) && RoiContours.frame(roi, image) > 0)
				contours
					.add(new Constraint(RoiContours.filament(roi), RoiContours.frame(roi, image),
						Constraint.Kind.CONTOUR, RoiContours.contour(roi)));
		}
		return contours;
	}

	private List<Roi> rois() {
		final List<Roi> rois = new ArrayList<>();
		for (final FilamentTrack filament : tracks.filaments())
			for (final Observation frame : filament.frames()) {
				if (frame.contour().isEmpty())
					continue;
				final Roi roi = converter.roi(frame.contour().get(), frame.frame(),
					number(filament));
				if (number(filament) == 0)
					roi.setStrokeColor(Palette.ofConfidence(frame.confidence()));
				roi.setProperty(OF_IMAGE, image.getTitle());
				rois.add(roi);
			}
		return rois;
	}

	/** 0 for the only filament. */
	private int number(final FilamentTrack filament) {
		return tracks.filaments().size() == 1 ? 0 : filament.id();
	}

	/** One by one: deleting a selection asks a person if the selection is lost. */
	private void removeEarlier(final RoiManager manager) {
		for (int i = manager.getCount() - 1; i >= 0; i--)
			if (image.getTitle().equals(manager.getRoi(i).getProperty(OF_IMAGE)))
				manager.delete(i);
	}

	/**
	 * Draws the contours over the image, coloured along their length, in place of
	 * those of an earlier run; what else is in the overlay stays.
	 */
	public void overlay() {
		final Overlay overlay = new Overlay();
		if (image.getOverlay() != null)
			for (final Roi roi : image.getOverlay())
				if (roi.getName() == null || !roi.getName().startsWith(RoiConverter.PREFIX))
					overlay.add(roi);
		for (final FilamentTrack filament : tracks.filaments())
			for (final Observation frame : filament.frames())
				frame.contour()
					.ifPresent(c -> pieces(c, frame.frame(), filament).forEach(overlay::add));
		image.setOverlay(overlay);
	}

	private List<Roi> pieces(final Polyline contour, final int frame,
		final FilamentTrack filament) {
		final Polyline line = contour.divided(PIECES * LINKS);
		final List<Roi> pieces = new ArrayList<>(PIECES);
		for (int i = 0; i < PIECES; i++) {
			final double[] x = Arrays.copyOfRange(line.xs(), i * LINKS, (i + 1) * LINKS + 1);
			final double[] y = Arrays.copyOfRange(line.ys(), i * LINKS, (i + 1) * LINKS + 1);
			final Roi roi = converter.roi(Polyline.of(x, y), frame, number(filament));
			roi.setStrokeColor(ContourPainter.colour(tracks, filament).apply((i + 0.5) / PIECES));
			pieces.add(roi);
		}
		return pieces;
	}
}
