package io.github.knotresolver.image;

import java.util.Arrays;
import java.util.stream.IntStream;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

/**
 * What can be seen of lines in one frame, in working pixels: where they are, how sure
 * that is, which way they run and how wide they are. Immutable.
 */
public final class FrameEvidence {

	/** Strengths are kept in these steps of the noise, from 0 to 255 of them. */
	private static final double STEP = 0.125;

	private final LineAppearance appearance;
	private final int width, height;
	/** Of the mask, each of a row. */
	private final int[] begins, ends;
	private final int[] places;
	private final byte[] z;
	private final float[] angles, widths;
	private final double surety;

	/**
	 * Keeps what is needed of them, a few bytes for a pixel of a line.
	 *
	 * @param ridges the frame's ridges
	 * @param mask the lines' masks
	 * @param skeleton their middle lines, one pixel wide
	 * @param surety see {@link #surety()}
	 */
	public FrameEvidence(final Ridges ridges, final Img<BitType> mask, final Img<BitType> skeleton,
		final double surety) {
		this.appearance = ridges.appearance();
		this.width = ridges.width();
		this.height = ridges.height();
		this.surety = surety;
		final boolean[] bits = Pixels.bits(mask);
		begins = runs(bits, width, true);
		ends = runs(bits, width, false);
		places = places(Pixels.bits(skeleton));
		z = new byte[places.length];
		angles = new float[places.length];
		widths = new float[places.length];
		for (int i = 0; i < places.length; i++) {
			z[i] = (byte) Math.max(0, Math.min(255, Math.rint(ridges.z(places[i]) / STEP)));
			angles[i] = (float) ridges.angle(places[i]);
			widths[i] = (float) ridges.lineWidth(places[i]);
		}
	}

	private FrameEvidence(final FrameEvidence whole, final int x, final int y, final int width,
		final int height) {
		appearance = whole.appearance;
		surety = whole.surety;
		this.width = width;
		this.height = height;
		final boolean[] bits = new boolean[width * height];
		whole.fill(bits, x, y, width, height);
		begins = runs(bits, width, true);
		ends = runs(bits, width, false);
		final int[] kept = IntStream.range(0, whole.places.length).filter(i -> whole.x(i) >= x
			&& whole.x(i) < x + width && whole.y(i) >= y && whole.y(i) < y + height).toArray();
		places = new int[kept.length];
		z = new byte[kept.length];
		angles = new float[kept.length];
		widths = new float[kept.length];
		for (int i = 0; i < kept.length; i++) {
			places[i] = (whole.y(kept[i]) - y) * width + whole.x(kept[i]) - x;
			z[i] = whole.z[kept[i]];
			angles[i] = whole.angles[kept[i]];
			widths[i] = whole.widths[kept[i]];
		}
	}

	/** Where runs of set pixels begin, or the first pixels after them; none goes on in the next row. */
	private static int[] runs(final boolean[] bits, final int width, final boolean begin) {
		int[] runs = new int[64];
		int count = 0;
		for (int at = 0; at < bits.length; at++) {
			if (!bits[at])
				continue;
			final boolean is = begin
				? at % width == 0 || !bits[at - 1]
				: at % width == width - 1 || !bits[at + 1];
			if (!is)
				continue;
			if (count == runs.length)
				runs = Arrays.copyOf(runs, 2 * count);
			runs[count++] = begin ? at : at + 1;
		}
		return Arrays.copyOf(runs, count);
	}

	/** Draws the mask of a part. */
	private void fill(final boolean[] bits, final int x, final int y, final int columns,
		final int rows) {
		for (int i = 0; i < begins.length; i++) {
			final int row = begins[i] / width - y, first = begins[i] % width - x;
			final int from = Math.max(0, first);
			final int to = Math.min(columns, first + ends[i] - begins[i]);
			if (row >= 0 && row < rows && from < to)
				Arrays.fill(bits, row * columns + from, row * columns + to, true);
		}
	}

	private static int[] places(final boolean[] bits) {
		final int[] places = new int[bits.length];
		int count = 0;
		for (int at = 0; at < bits.length; at++)
			if (bits[at])
				places[count++] = at;
		return Arrays.copyOf(places, count);
	}

	/** @return what the movie's lines look like, and how large a working pixel is */
	public LineAppearance appearance() {
		return appearance;
	}

	/** @return width of the frame in working pixels */
	public int width() {
		return width;
	}

	/** @return height of the frame in working pixels */
	public int height() {
		return height;
	}

	/**
	 * @param x first column of a part of the frame
	 * @param y its first row
	 * @param columns number of its columns
	 * @param rows number of its rows
	 * @return the evidence in this part, in the part's own pixels
	 */
	public FrameEvidence part(final int x, final int y, final int columns, final int rows) {
		return new FrameEvidence(this, x, y, columns, rows);
	}

	/** @return the lines' masks, a new image; O(pixels) */
	public Img<BitType> mask() {
		final boolean[] bits = new boolean[width * height];
		fill(bits, 0, 0, width, height);
		return Pixels.mask(bits, width);
	}

	/** @return the lines' middle lines, one pixel wide, a new image; O(pixels) */
	public Img<BitType> skeleton() {
		final boolean[] bits = new boolean[width * height];
		for (final int place : places)
			bits[place] = true;
		return Pixels.mask(bits, width);
	}

	/** @return number of pixels of the skeleton */
	public int size() {
		return places.length;
	}

	/**
	 * @param i 0 to below {@link #size()}, in order of rows
	 * @return column of a pixel of the skeleton
	 */
	public int x(final int i) {
		return places[i] % width;
	}

	/**
	 * @param i 0 to below {@link #size()}, in order of rows
	 * @return row of a pixel of the skeleton
	 */
	public int y(final int i) {
		return places[i] / width;
	}

	/**
	 * How sure it is that there is any line: z less what noise gives, added up along the
	 * surest part in units of its own standard deviation. Noise reaches 5, haze 8; a line
	 * of 5 photons has 20; 0 where nothing was found.
	 *
	 * @return at least 0
	 */
	public double surety() {
		return surety;
	}

	/**
	 * Ridge strength in units of its local noise: about 1 on average where there is nothing,
	 * seldom above 4.
	 *
	 * @param x column of a pixel of the skeleton
	 * @param y its row
	 * @return 0 to 31.9, in steps of an eighth; NaN off the skeleton
	 */
	public double z(final int x, final int y) {
		final int i = Arrays.binarySearch(places, y * width + x);
		return i < 0 ? Double.NaN : STEP * (z[i] & 255);
	}

	/**
	 * @param x column of a pixel of the skeleton
	 * @param y its row
	 * @return direction along the line there in radians, 0 to below pi, from x towards y,
	 *         in steps of pi/8; NaN off the skeleton
	 */
	public double angle(final int x, final int y) {
		final int i = Arrays.binarySearch(places, y * width + x);
		return i < 0 ? Double.NaN : angles[i];
	}

	/**
	 * @param x column of a pixel of the skeleton
	 * @param y its row
	 * @return full width at half maximum of the line there, in the movie's (not the
	 *         working) pixels; where strands lie side by side, that of both together; NaN
	 *         off the skeleton
	 */
	public double lineWidth(final int x, final int y) {
		final int i = Arrays.binarySearch(places, y * width + x);
		return i < 0 ? Double.NaN : widths[i];
	}
}
