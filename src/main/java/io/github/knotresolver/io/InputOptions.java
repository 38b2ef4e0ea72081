package io.github.knotresolver.io;

import java.util.Optional;
import java.util.OptionalDouble;

import io.github.knotresolver.model.Calibration;

/**
 * How a movie is taken from an image file.
 *
 * @param channel 1-based channel
 * @param zAsTime whether a Z-stack is read as a time series
 * @param pixelSize edge of a pixel; empty for the image's
 * @param frameInterval seconds between frames; empty for the image's
 * @param unit unit of length; empty for the image's or, if a pixel size is told
 *          for an image without unit, µm
 */
public record InputOptions(int channel, boolean zAsTime, OptionalDouble pixelSize,
	OptionalDouble frameInterval, Optional<String> unit) {

	/** The first channel, with the image's own calibration. */
	public static final InputOptions DEFAULT = new InputOptions(1, false, OptionalDouble.empty(),
		OptionalDouble.empty(), Optional.empty());

	private static final String MICROMETRE = "µm";

	/**
	 * What was told, over what the image says.
	 *
	 * @param image the image's own calibration
	 * @return the calibration to use
	 */
	public Calibration over(final Calibration image) {
		final boolean sized = pixelSize.isPresent();
		final String unitOfImage = sized && !image.hasLengthUnit() ? MICROMETRE : image.unit();
		return new Calibration(pixelSize.orElse(image.pixelSize()), unit.orElse(unitOfImage),
			frameInterval.orElse(image.frameInterval()),
			frameInterval.isPresent() ? "s" : image.timeUnit());
	}
}
