package io.github.knotresolver.imagej.plot;

import java.awt.Color;
import java.awt.Paint;

import org.jfree.chart.renderer.PaintScale;

import ij.process.ImageProcessor;
import ij.process.LUT;

/**
 * Colours for a range of values, safe for colour-blind readers and in grey
 * print.
 */
final class ColourMap implements PaintScale {

	/** What has no value. */
	static final Color MISSING = new Color(0xd9, 0xd9, 0xd9);

	/** Rising lightness, blue violet to yellow: for values without a middle. */
	private static final int[] RISING = {0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80,
		0x5ec962, 0xaddc30, 0xfde725};
	/** Blue over white to red: for values on both sides of zero. */
	private static final int[] TWO_SIDED = {0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xf7f7f7,
		0xf4a582, 0xd6604d, 0xb2182b, 0x67001f};

	private static final int LEVELS = 256;
	/** Part of the range below its low end that keeps level 0 for what is missing. */
	private static final double BELOW = 0.01;

	private final int[] colours;
	private final double low;
	private final double high;

	private ColourMap(final int[] colours, final double low, final double high) {
		this.colours = colours;
		this.low = low;
		this.high = high;
	}

	/** @return dark to light from {@code low} to {@code high} */
	static ColourMap rising(final double low, final double high) {
		return new ColourMap(RISING, low, high > low ? high : low + 1);
	}

	/** @return blue for {@code -limit}, white for 0, red for {@code limit} */
	static ColourMap twoSided(final double limit) {
		final double end = limit > 0 ? limit : 1;
		return new ColourMap(TWO_SIDED, -end, end);
	}

	@Override
	public double getLowerBound() {
		return low;
	}

	@Override
	public double getUpperBound() {
		return high;
	}

	@Override
	public Paint getPaint(final double value) {
		return colour(value);
	}

	Color colour(final double value) {
		if (Double.isNaN(value))
			return MISSING;
		final double part = Math.min(1, Math.max(0, (value - low) / (high - low)));
		final double place = part * (colours.length - 1);
		final int i = Math.min(colours.length - 2, (int) place);
		final double f = place - i;
		return new Color(mix(i, 16, f), mix(i, 8, f), mix(i, 0, f));
	}

	/**
	 * Shows an image of numbers in these colours. ImageJ draws NaN as the lowest
	 * of 256 levels; no number has it here.
	 */
	void applyTo(final ImageProcessor pixels) {
		final double floor = low - BELOW * (high - low);
		final byte[][] rgb = new byte[3][LEVELS];
		for (int i = 0; i < LEVELS; i++) {
			final Color c = i == 0 ? MISSING : colour(floor + (high - floor) * i / (LEVELS - 1));
			rgb[0][i] = (byte) c.getRed();
			rgb[1][i] = (byte) c.getGreen();
			rgb[2][i] = (byte) c.getBlue();
		}
		pixels.setLut(new LUT(rgb[0], rgb[1], rgb[2]));
		pixels.setMinAndMax(floor, high);
	}

	private int mix(final int i, final int shift, final double f) {
		final int a = colours[i] >> shift & 0xff, b = colours[i + 1] >> shift & 0xff;
		return (int) Math.rint(a + f * (b - a));
	}
}
