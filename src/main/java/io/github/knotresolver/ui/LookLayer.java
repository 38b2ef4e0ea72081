package io.github.knotresolver.ui;

import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

import ij.ImagePlus;
import ij.gui.Overlay;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.imagej.LookOverlay;
import io.github.knotresolver.imagej.RoiConverter;
import io.github.knotresolver.session.FrameLook;

/** What is drawn on an image for a while, in place of contours of earlier runs. */
final class LookLayer implements AutoCloseable {

	private final ImagePlus image;
	private final ImageSource source;
	private final RoiConverter places;
	private final Overlay before;
	private Optional<FrameLook> shown = Optional.empty();
	private LookOverlay.Parts parts = LookOverlay.Parts.ALL;
	private SortedMap<Integer, List<Polyline>> sightings = new TreeMap<>();
	private Overlay drawn;

	LookLayer(final ImagePlus image) {
		this.image = image;
		source = ImageSource.inMemory(image);
		places = RoiConverter.forImage(image, image.getC());
		before = image.getOverlay();
	}

	boolean isOf(final ImagePlus other) {
		return image == other;
	}

	/** @return the movie in the image, always the same */
	ImageSource source() {
		return source;
	}

	/** Draws other parts of the same. */
	void show(final LookOverlay.Parts wanted) {
		if (wanted.equals(parts))
			return;
		parts = wanted;
		final Optional<FrameLook> again = shown;
		shown = Optional.empty();
		show(again);
	}

	/** Draws; nothing of an empty look. */
	void show(final Optional<FrameLook> look) {
		if (look.equals(shown))
			return;
		shown = look;
		drawn = look.map(l -> LookOverlay.of(l, parts, places, before)).orElse(before);
		image.setOverlay(drawn);
	}

	/** Draws contours while they are being found, in every frame; nothing new if there are none. */
	void show(final SortedMap<Integer, List<Polyline>> found) {
		if (found.isEmpty() || found.equals(sightings))
			return;
		sightings = found;
		drawn = LookOverlay.of(found, places, before);
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
