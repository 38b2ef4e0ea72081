package io.github.knotresolver.imagej;

import java.util.List;
import java.util.SortedMap;

import ij.gui.Overlay;
import ij.gui.Roi;
import io.github.knotresolver.geometry.Polyline;

/** Contours over an image while they are being found: thin lines, each at its frame. */
public final class SightingOverlay {

	private static final double LINE = 1;

	private SightingOverlay() {
	}

	/**
	 * @param sightings contours in pixels by 1-based frame
	 * @param places sets the positions of frames
	 * @param before the image's overlay, which is shown, too; may be null
	 * @return the shapes
	 */
	public static Overlay of(final SortedMap<Integer, List<Polyline>> sightings,
		final RoiConverter places, final Overlay before) {
		final Overlay overlay = LookOverlay.without(before);
		sightings.forEach((frame, contours) -> {
			for (int i = 0; i < contours.size(); i++) {
				final Roi line = RoiConverter.polyline(contours.get(i));
				line.setStrokeColor(Palette.ofFilament(i + 1));
				line.setUnscalableStrokeWidth(LINE);
				line.setName(LookOverlay.PREFIX + "sighted");
				overlay.add(places.placed(line, frame));
			}
		});
		return overlay;
	}
}
