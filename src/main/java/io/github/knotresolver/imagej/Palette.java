package io.github.knotresolver.imagej;

import java.awt.Color;

import io.github.knotresolver.model.FrameStatus;

/**
 * Colours that people with any colour vision tell apart: a ramp of rising
 * lightness along a filament, from blue violet at the fixed end over red to
 * yellow at the tip, bright enough on a dark image; a colour of its own for each of
 * several filaments; and one colour a status (after Okabe and Ito).
 */
final class Palette {

	/** The mark of the fixed end. */
	static final Color FIXED_END = new Color(0x56, 0xb4, 0xe9);

	/** After Okabe and Ito, lightened for a dark image. */
	private static final Color[] FILAMENTS = {new Color(0x56, 0xb4, 0xe9),
		new Color(0xf0, 0xa5, 0x20), new Color(0x2f, 0xd0, 0x9c), new Color(0xe3, 0x8a, 0xbf),
		new Color(0xf0, 0xe4, 0x42), new Color(0xff, 0x74, 0x38), new Color(0x6f, 0x8f, 0xff),
		new Color(0xe8, 0xe8, 0xe8)};
	/** How bright a filament is at its first end, of its own colour at the last. */
	private static final double DARKEST = 0.55;

	private static final int[][] RAMP = {{0x8b, 0x5c, 0xf6}, {0xb8, 0x4d, 0xd8}, {0xdc, 0x4a, 0xa8},
		{0xf0, 0x5f, 0x73}, {0xf8, 0x87, 0x4a}, {0xfb, 0xb5, 0x33}, {0xf5, 0xe6, 0x4a}};

	private Palette() {
	}

	/**
	 * @param fraction place along the filament, 0 at the fixed end to 1 at the tip
	 * @return its colour
	 */
	static Color along(final double fraction) {
		final double place = Math.min(1, Math.max(0, fraction)) * (RAMP.length - 1);
		final int i = Math.min(RAMP.length - 2, (int) place);
		return new Color(mix(i, 0, place - i), mix(i, 1, place - i), mix(i, 2, place - i));
	}

	private static int mix(final int i, final int channel, final double f) {
		return (int) Math.rint(RAMP[i][channel] + f * (RAMP[i + 1][channel] - RAMP[i][channel]));
	}

	/**
	 * @param filament number of a filament, from 1
	 * @return its colour, told apart from those of the next seven
	 */
	static Color ofFilament(final int filament) {
		return FILAMENTS[(filament - 1) % FILAMENTS.length];
	}

	/**
	 * @param filament number of one of several filaments
	 * @param fraction place along it, 0 at the first end to 1 at the last
	 * @return its colour, getting brighter along it
	 */
	static Color along(final int filament, final double fraction) {
		final Color colour = ofFilament(filament);
		final double f = DARKEST + (1 - DARKEST) * Math.min(1, Math.max(0, fraction));
		return new Color((int) (colour.getRed() * f), (int) (colour.getGreen() * f),
			(int) (colour.getBlue() * f));
	}

	/**
	 * @param status a frame's status
	 * @return its colour
	 */
	static Color of(final FrameStatus status) {
		return switch (status) {
			case RESOLVED -> new Color(0x00, 0x9e, 0x73);
			case CORRECTED -> new Color(0x00, 0x72, 0xb2);
			case UNRESOLVED -> new Color(0xe6, 0x9f, 0x00);
			case LOST -> new Color(0xd5, 0x5e, 0x00);
			case ABSENT -> new Color(0xb0, 0xb0, 0xb0);
			case IGNORED -> new Color(0x80, 0x80, 0x80);
		};
	}

	/**
	 * @param confidence 0..1
	 * @return green where it is sure, yellow where it may be, orange where it is not
	 */
	static Color ofConfidence(final double confidence) {
		if (confidence >= 0.9)
			return new Color(0x00, 0x9e, 0x73);
		return confidence >= 0.5 ? new Color(0xf0, 0xe4, 0x42) : new Color(0xe6, 0x9f, 0x00);
	}
}
