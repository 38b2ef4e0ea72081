package io.github.knotresolver.imagej;

import java.util.LinkedHashMap;
import java.util.Map;

import ij.ImagePlus;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.UserException;

/** What a person says by a selection in the image. */
public final class ImageSelection {

	private static final String FIXED_END = "fixed_end", REGION = "region";

	private ImageSelection() {
	}

	/**
	 * A point selection is the fixed end, an area selection limits the search; what the options say
	 * counts more.
	 *
	 * @param texts options by key, with {@code fixed_end} and {@code region}
	 * @param image the image
	 * @return the options with what the selection says
	 * @throws UserException if the area is too small, in one sentence
	 */
	public static Map<String, String> over(final Map<String, String> texts, final ImagePlus image) {
		final Map<String, String> all = new LinkedHashMap<>(texts);
		if (texts.get(FIXED_END).isBlank())
			all.put(FIXED_END, RoiConverter.point(image.getRoi()).map(Point::toString).orElse(""));
		if (texts.get(REGION).isBlank())
			all.put(REGION, RoiConverter.region(image).map(Region::toString).orElse(""));
		return all;
	}
}
