package io.github.knotresolver.imagej.tiff;

import java.util.Map;

/** One image of a TIFF file, as its directory describes it. */
final class TiffPage {

	static final int SUBFILE_TYPE = 254, WIDTH = 256, HEIGHT = 257, BITS = 258, COMPRESSION = 259,
		PHOTOMETRIC = 262, DESCRIPTION = 270, STRIP_OFFSETS = 273, SAMPLES = 277,
		STRIP_COUNTS = 279, X_RESOLUTION = 282, Y_RESOLUTION = 283, RESOLUTION_UNIT = 296,
		PREDICTOR = 317, COLOUR_MAP = 320, TILE_OFFSETS = 324, TILE_COUNTS = 325,
		SAMPLE_FORMAT = 339;

	static final int UNSIGNED = 1, SIGNED = 2, FLOAT = 3;
	static final int PALETTE = 3, RGB = 2;
	private static final int REDUCED_OR_MASK = 5;

	private final Map<Integer, long[]> values;
	private final String description;

	/**
	 * @param values by tag; numerator and denominator of rationals
	 * @param description the text of {@code ImageDescription}; empty if there is none
	 */
	TiffPage(final Map<Integer, long[]> values, final String description) {
		this.values = Map.copyOf(values);
		this.description = description;
	}

	/** @return the values of a tag; none if it is absent */
	long[] values(final int tag) {
		return values.getOrDefault(tag, new long[0]).clone();
	}

	private long value(final int tag, final long otherwise) {
		final long[] all = values.get(tag);
		return all == null || all.length == 0 ? otherwise : all[0];
	}

	String description() {
		return description;
	}

	long width() {
		return value(WIDTH, 0);
	}

	long height() {
		return value(HEIGHT, 0);
	}

	int bits() {
		return (int) value(BITS, 1);
	}

	int samples() {
		return (int) value(SAMPLES, 1);
	}

	/** @return whether samples are unsigned (1), signed (2) or floating point (3) numbers */
	int format() {
		return (int) value(SAMPLE_FORMAT, UNSIGNED);
	}

	int compression() {
		return (int) value(COMPRESSION, 1);
	}

	int photometric() {
		return (int) value(PHOTOMETRIC, 1);
	}

	int predictor() {
		return (int) value(PREDICTOR, 1);
	}

	boolean isTiled() {
		return values.containsKey(TILE_OFFSETS);
	}

	/** @return whether it is a thumbnail, or a mask, of another image */
	boolean isReduced() {
		return (value(SUBFILE_TYPE, 0) & REDUCED_OR_MASK) != 0;
	}

	/** @return pixels a unit, along x or y; NaN if it is not told */
	double resolution(final int tag) {
		final long[] ratio = values.getOrDefault(tag, new long[0]);
		return ratio.length == 2 && ratio[1] != 0 ? (double) ratio[0] / ratio[1] : Double.NaN;
	}

	/** @return 1 for none, 2 for inches, 3 for centimetres */
	int resolutionUnit() {
		return (int) value(RESOLUTION_UNIT, 2);
	}

	/** @return bytes of its pixels without compression */
	double bytes() {
		return Math.ceil((double) width() * bits() / 8) * height() * samples();
	}

	/** @return whether the pixels of both are the same kind and number */
	boolean isLike(final TiffPage other) {
		return width() == other.width() && height() == other.height() && bits() == other.bits()
			&& samples() == other.samples() && format() == other.format();
	}

	/** @return what it is, for messages: {@code 100 x 54 of 16 bit} */
	@Override
	public String toString() {
		return width() + " x " + height() + " of " + bits() + " bit";
	}
}
