package io.github.knotresolver.options;

import java.util.Optional;
import java.util.OptionalDouble;

import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;

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

	/**
	 * What was told, over what the image says.
	 *
	 * @param image the image's own calibration
	 * @return the calibration to use
	 * @throws UserException if units are missing or implausible; in one sentence
	 */
	public Calibration over(final Calibration image) {
		return new CalibrationChoice(pixelSize, unit, frameInterval).over(image);
	}

	/**
	 * @param image what an image says
	 * @return the same with its time in seconds, if its unit of time is known
	 */
	public static Calibration inSeconds(final Calibration image) {
		return CalibrationChoice.inSeconds(image);
	}

	/**
	 * @param image what an image says
	 * @return whether its unit of length is one that a microscope's image may have; so
	 *         is none
	 */
	public static boolean isPlausible(final Calibration image) {
		return CalibrationChoice.isPlausible(image);
	}
}
