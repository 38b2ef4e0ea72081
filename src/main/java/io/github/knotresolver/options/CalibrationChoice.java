package io.github.knotresolver.options;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Optional;
import java.util.OptionalDouble;

import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.ShownNumber;
import io.github.knotresolver.model.UserException;

/**
 * What a person tells about pixels and frames, over what an image or a result
 * tells. Nothing is guessed: a number without its unit, or a unit that no
 * microscope's image has, is refused with what to say instead.
 *
 * @param pixelSize edge of a pixel; empty if it is not told
 * @param unit unit of length; empty if it is not told
 * @param frameInterval seconds between frames; empty if it is not told
 */
public record CalibrationChoice(OptionalDouble pixelSize, Optional<String> unit,
	OptionalDouble frameInterval) {

	/** Pixels of microscopes, in µm: from a tenth of a nanometre to a millimetre. */
	private static final double SMALLEST = 1e-4, LARGEST = 1e3;
	/** In centimetres, as in inches, print resolutions are told: 500 dots a centimetre. */
	private static final double LARGEST_IN_CM = 20;
	/** Seconds between frames: a nanosecond to a year. */
	private static final double SHORTEST = 1e-9, LONGEST = 3.2e7;

	/**
	 * @param image what the image or result tells
	 * @return the calibration to use; its time is in seconds, or in frames
	 * @throws UserException if units are missing, do not fit each other, or are
	 *           implausible; in one sentence that says what to tell
	 */
	public Calibration over(final Calibration image) {
		final Calibration length = length(image);
		final Calibration time = time(image);
		return new Calibration(length.pixelSize(), length.unit(), time.frameInterval(),
			time.timeUnit());
	}

	/**
	 * @param c a calibration
	 * @return the same with its time in seconds, if its unit of time is known
	 */
	public static Calibration inSeconds(final Calibration c) {
		final OptionalDouble seconds = UnitText.seconds(c.timeUnit());
		return seconds.isEmpty() || seconds.getAsDouble() == 1
			? c
			: new Calibration(c.pixelSize(), c.unit(), inSeconds(c.frameInterval(), seconds),
				UnitText.SECOND);
	}

	/** By division where the unit is a part of a second: 100 ms are 0.1 s to the last digit. */
	private static double inSeconds(final double interval, final OptionalDouble unit) {
		final double size = unit.getAsDouble();
		return size < 1 ? interval / Math.rint(1 / size) : interval * size;
	}

	/**
	 * @param image what an image tells
	 * @return whether its unit of length is one that a microscope's image may have;
	 *         so is none
	 */
	public static boolean isPlausible(final Calibration image) {
		if (!image.hasLengthUnit())
			return true;
		final OptionalDouble size = UnitText.micrometres(image.unit());
		return size.isPresent() && !image.unit().equals("inch")
			&& isPlausible(size.getAsDouble() * image.pixelSize()) && !(image.unit().equals("cm")
				&& image.pixelSize() * size.getAsDouble() > LARGEST_IN_CM);
	}

	private static boolean isPlausible(final double micrometres) {
		return micrometres >= SMALLEST * (1 - 1e-9) && micrometres <= LARGEST * (1 + 1e-9);
	}

	private Calibration length(final Calibration image) {
		return pixelSize.isPresent() ? told(pixelSize.getAsDouble(), image) : known(image);
	}

	private Calibration told(final double size, final Calibration image) {
		final boolean named = unit.isPresent();
		if (!named && image.hasLengthUnit() && !image.unit().equals(UnitText.MICROMETRE))
			throw new UserException("pixel_size is " + ShownNumber.of(size)
				+ ", but not in which unit, and the image's own is " + image.unit()
				+ "; add unit=µm, or add unit=" + image.unit() + ".");
		final String in = unit.orElse(UnitText.MICROMETRE);
		if (in.equals(Calibration.NONE.unit()))
			throw new UserException("pixel_size is " + ShownNumber.of(size)
				+ ", but unit is pixel, in which a pixel is 1; leave one of them out.");
		final OptionalDouble micrometres = UnitText.micrometres(in);
		if (micrometres.isPresent() && !isPlausible(size * micrometres.getAsDouble()))
			throw new UserException("pixel_size must be from 0.1 nm to 1 mm, but is "
				+ ShownNumber.of(size) + " " + in + ".");
		return new Calibration(size, in, 1, Calibration.NONE.timeUnit());
	}

	private Calibration known(final Calibration image) {
		if (unit.isEmpty()) {
			if (!isPlausible(image))
				throw new UserException("The image's pixels are "
					+ ShownNumber.of(image.pixelSize()) + " " + image.unit()
					+ " large, which is no microscope's; tell pixel_size and unit, or unit=pixel for results in pixels.");
			return image;
		}
		final String in = unit.get();
		if (in.equals(Calibration.NONE.unit()))
			return Calibration.NONE;
		if (in.equals(image.unit()))
			return image;
		final OptionalDouble from = UnitText.micrometres(image.unit()),
			to = UnitText.micrometres(in);
		if (from.isEmpty() || to.isEmpty())
			throw new UserException("unit is " + in + ", but the pixels' size is known in "
				+ image.unit() + " only; tell pixel_size, too.");
		return new Calibration(rounded(image.pixelSize() * from.getAsDouble() / to.getAsDouble()),
			in, 1, Calibration.NONE.timeUnit());
	}

	/** To twelve digits: a conversion of units leaves no trace of binary fractions. */
	private static double rounded(final double value) {
		return new BigDecimal(value).round(new MathContext(12, RoundingMode.HALF_EVEN))
			.doubleValue();
	}

	private Calibration time(final Calibration image) {
		final Calibration in = frameInterval.isPresent()
			? new Calibration(1, Calibration.NONE.unit(), frameInterval.getAsDouble(),
				UnitText.SECOND)
			: inSeconds(image);
		if (!in.hasTimeUnit())
			return Calibration.NONE;
		if (!in.timeUnit().equals(UnitText.SECOND))
			throw new UserException("The image's frames are "
				+ ShownNumber.of(image.frameInterval()) + " " + image.timeUnit()
				+ " apart, which is no unit of time; tell frame_interval in seconds.");
		if (!(in.frameInterval() >= SHORTEST && in.frameInterval() <= LONGEST))
			throw new UserException("frame_interval must be from 1e-9 s to a year, but is "
				+ ShownNumber.of(in.frameInterval()) + " s.");
		return in;
	}
}
