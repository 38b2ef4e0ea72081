package io.github.knotresolver.ui;

import java.util.List;
import java.util.SortedMap;

import ij.ImagePlus;
import ij.gui.Overlay;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.LookOverlay;
import io.github.knotresolver.imagej.RoiConverter;

/** Contours on an image while they are being found. */
final class SightingLayer implements AutoCloseable {

	private final ImagePlus image;
	private final RoiConverter places;
	private final Overlay before;
	private Overlay drawn;
	private SortedMap<Integer, List<Polyline>> shown;

	SightingLayer(final ImagePlus image) {
		this.image = image;
		places = RoiConverter.forImage(image, image.getC());
		before = image.getOverlay();
	}

	void show(final SortedMap<Integer, List<Polyline>> sightings) {
		if (sightings.isEmpty() || sightings.equals(shown))
			return;
		shown = sightings;
		drawn = LookOverlay.of(sightings, places, before);
		image.setOverlay(drawn);
	}

	/** The image is as it was before, unless others have drawn on it meanwhile. */
	@Override
	public void close() {
		if (drawn != null && image.getOverlay() == drawn)
			image.setOverlay(before);
		drawn = null;
	}
}
