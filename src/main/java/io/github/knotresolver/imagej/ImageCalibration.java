
package io.github.knotresolver.imagej;

import ij.ImagePlus;
import ij.io.FileInfo;
import io.github.knotresolver.imagej.tiff.OmeXml;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.UnitText;

/**
 * What an image says about the size of its pixels and the time between its
 * frames. Where it says nothing, so do we: the rate at which ImageJ plays a
 * stack (fps) is not a time between frames.
 */
public final class ImageCalibration {

	/** Pixels may differ from squares by this share: rounding in metadata. */
	private static final double SQUARE = 0.01;

	private ImageCalibration() {
	}

	/**
	 * @param image an image
	 * @return its calibration, its time in seconds if its unit of time is known; pixels
	 *         and frames where the image says nothing
	 * @throws UserException if its pixels are not square
	 */
	public static Calibration of(final ImagePlus image) {
		final ij.measure.Calibration c = withOme(image);
		final Calibration none = Calibration.NONE;
		final String unit = UnitText.length(c.getUnit());
		final boolean sized = !unit.equals(none.unit()) && isPositive(c.pixelWidth);
		if (sized && Math.abs(c.pixelWidth - c.pixelHeight) > SQUARE * c.pixelWidth)
			throw new UserException("Pixels must be square, but those of '" + image.getTitle()
				+ "' are " + c.pixelWidth + " x " + c.pixelHeight + " " + unit
				+ "; rescale the image with Image > Scale.");
		final boolean timed = isPositive(c.frameInterval);
		return InputOptions.inSeconds(new Calibration(sized ? c.pixelWidth : none.pixelSize(),
			sized ? unit : none.unit(), timed ? c.frameInterval : none.frameInterval(),
			timed ? UnitText.time(c.getTimeUnit()) : none.timeUnit()));
	}

	/** ImageJ's opener leaves the metadata of an OME-TIFF unread. */
	private static ij.measure.Calibration withOme(final ImagePlus image) {
		final FileInfo info = image.getOriginalFileInfo();
		final ij.measure.Calibration c = image.getCalibration();
		if (info == null || c.scaled() || !OmeXml.isOme(info.description))
			return c;
		final ij.measure.Calibration copy = c.copy();
		try {
			OmeXml.parse(image.getTitle(), info.description).calibrate(copy);
			return copy;
		} catch (final UserException e) {
			// One of several images: which one was opened is not told.
			return c;
		}
	}

	private static boolean isPositive(final double value) {
		return value > 0 && Double.isFinite(value);
	}
}
