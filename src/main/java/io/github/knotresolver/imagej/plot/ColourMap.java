package io.github.knotresolver.imagej.plot;

import java.awt.Color;
import java.awt.Paint;

import org.jfree.chart.renderer.PaintScale;

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

	private int mix(final int i, final int shift, final double f) {
		final int a = colours[i] >> shift & 0xff, b = colours[i + 1] >> shift & 0xff;
		return (int) Math.rint(a + f * (b - a));
	}
}
