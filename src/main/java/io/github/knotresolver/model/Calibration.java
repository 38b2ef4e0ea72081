package io.github.knotresolver.model;

/**
 * How pixels and frames become units of length and time. Pixels are square.
 *
 * @param pixelSize edge of a pixel in {@code unit}, above 0
 * @param unit unit of length, such as {@code µm}, or {@code pixel}
 * @param frameInterval time between frames in {@code timeUnit}, above 0
 * @param timeUnit unit of time, such as {@code s}, or {@code frame}
 */
public record Calibration(double pixelSize, String unit, double frameInterval, String timeUnit) {

	/** Pixels and frames: nothing is known, and nothing is made up. */
	public static final Calibration NONE = new Calibration(1, "pixel", 1, "frame");

	public Calibration {
		if (!(pixelSize > 0) || Double.isInfinite(pixelSize))
			throw new IllegalArgumentException(
				"The pixel size must be above 0, but is " + pixelSize + ".");
		if (!(frameInterval > 0) || Double.isInfinite(frameInterval))
			throw new IllegalArgumentException(
				"The frame interval must be above 0, but is " + frameInterval + ".");
	}

	/** @return whether lengths have a unit other than pixels */
	public boolean hasLengthUnit() {
		return !unit.equals(NONE.unit);
	}

	/** @return whether times have a unit other than frames */
	public boolean hasTimeUnit() {
		return !timeUnit.equals(NONE.timeUnit);
	}

	/** @return unit of frequencies: {@code Hz}, or {@code 1/unit of time} */
	public String frequencyUnit() {
		return timeUnit.equals("s") ? "Hz" : "1/" + timeUnit;
	}
}
