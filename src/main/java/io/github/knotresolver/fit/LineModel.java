package io.github.knotresolver.fit;

import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;

/**
 * What a line looks like in the movie, in normalised intensities (background 0,
 * a single bright strand 1).
 * <ul>
 * <li>{@link Kind#SATURATING}: a pixel's value depends on its distance d to the
 * nearest point of the curve, exp(-(d²/2σ²)^p): strands that cross are not
 * brighter (clipped or thresholded pictures, dilated skeletons);</li>
 * <li>{@link Kind#BRIGHTEST}: the light of a filament adds up as through a lens, and is cut off
 * at 1; of several filaments the brightest is seen;</li>
 * <li>{@link Kind#ADDITIVE}: every strand adds its light, the line integral of a
 * Gaussian point spread function: strands that cross are brighter
 * (fluorescence in its linear range).</li>
 * </ul>
 *
 * @param kind how strands add up
 * @param sigma width σ in pixels, above 0
 * @param power p of the saturating profile (1 is a Gaussian, larger is flatter); of one that is
 *          cut off, how many times as bright it would be without; 1 for the additive model
 * @param brightness relative brightness along the filament, at equal spacing from
 *          the fixed end to the free tip, at least one value
 */
public record LineModel(Kind kind, double sigma, double power, double[] brightness) {

	/** How strands may add up where no pixel was cut off: the movie tells which it is. */
	public static final Set<Kind> UNCLIPPED = Collections
		.unmodifiableSet(EnumSet.of(Kind.SATURATING, Kind.ADDITIVE));

	/** How strands that lie on each other add up. */
	public enum Kind {

		/** A crossing is as bright as one strand; ends are blunt. */
		SATURATING,
		/** A crossing is as bright as one strand; ends and strands side by side are a lens's. */
		BRIGHTEST,
		/** A crossing is as bright as its strands together. */
		ADDITIVE

	}

	public LineModel {
		if (!(sigma > 0))
			throw new IllegalArgumentException(
				"The line's sigma must be above 0 pixels, but is " + sigma + ".");
		if (!(power >= 0.5 && power <= 10))
			throw new IllegalArgumentException(
				"The line's power must be from 0.5 to 10, but is " + power + ".");
		if (brightness.length == 0)
			throw new IllegalArgumentException(
				"The brightness along the filament needs at least one value.");
		brightness = brightness.clone();
	}

	/**
	 * A line of the same brightness everywhere.
	 *
	 * @param kind how strands add up
	 * @param sigma width σ in pixels
	 * @param power p of the profile
	 * @return the model
	 */
	public static LineModel uniform(final Kind kind, final double sigma, final double power) {
		return new LineModel(kind, sigma, power, new double[]{1});
	}

	@Override
	public double[] brightness() {
		return brightness.clone();
	}

	/**
	 * @param values new relative brightness along the filament
	 * @return the same line with that brightness
	 */
	public LineModel withBrightness(final double[] values) {
		return new LineModel(kind, sigma, power, values);
	}

	/** The same line, so wide. */
	LineModel withSigma(final double width) {
		return new LineModel(kind, width, power, brightness);
	}

	/** @return whether it is as bright everywhere */
	public boolean isEven() {
		return brightness.length == 1;
	}

	/** @return whether an end of it is so dim that where it ends is hardly seen */
	public boolean hasDimEnd() {
		return Math.min(brightness[0], atTip()) < FitTuning.DIM_END;
	}

	/** @return brightness of its tip, in strands */
	public double atTip() {
		return brightness[brightness.length - 1];
	}

	/** @return the same line in a frame in which it is so many times as wide */
	LineModel in(final NormalizedFrame frame) {
		return frame.widening() == 1 ? this : withSigma(sigma * frame.widening());
	}

	/** @return the same line, run from its tip to its fixed end */
	LineModel reversed() {
		final double[] values = new double[brightness.length];
		for (int i = 0; i < values.length; i++)
			values[i] = brightness[brightness.length - 1 - i];
		return withBrightness(values);
	}

	/** The brightness of each of {@code links} links, by linear interpolation. */
	double[] brightnessOfLinks(final int links) {
		final double[] values = new double[links];
		for (int i = 0; i < links; i++) {
			final double at = (i + 0.5) / links * (brightness.length - 1);
			final int lo = Math.min((int) at, brightness.length - 1);
			final int hi = Math.min(lo + 1, brightness.length - 1);
			values[i] = brightness[lo] + (at - lo) * (brightness[hi] - brightness[lo]);
		}
		return values;
	}

	/** Distance in pixels beyond which the line is dark (below 0.1 %). */
	double reach() {
		return sigma * Math.sqrt(2) * Math.pow(Math.log(1000), 0.5 / power);
	}

	@Override
	public boolean equals(final Object o) {
		return o instanceof LineModel m && kind == m.kind && sigma == m.sigma && power == m.power
			&& Arrays.equals(brightness, m.brightness);
	}

	@Override
	public int hashCode() {
		return Arrays
			.hashCode(new double[]{kind.ordinal(), sigma, power, Arrays.hashCode(brightness)});
	}

	@Override
	public String toString() {
		return String.format(Locale.ROOT, "%s line, sigma %.2f px, power %.2f",
			kind.name().toLowerCase(Locale.ROOT), sigma, power);
	}
}
