package io.github.knotresolver.image;

import java.util.Arrays;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.view.Views;

/**
 * What can be seen of lines in one frame, in working pixels: where they are, how sure
 * that is, which way they run and how wide they are. Immutable.
 */
public final class FrameEvidence {

	/** Strengths are kept in these steps of the noise, from 0 to 255 of them. */
	private static final double STEP = 0.125;

	private final LineAppearance appearance;
	private final int width;
	private final Img<BitType> mask, skeleton;
	private final byte[] z;
	private final int[] places;
	private final float[] angles, widths;
	private final double surety;

	/**
	 * @param ridges the frame's ridges
	 * @param mask the lines' masks; kept, not copied
	 * @param skeleton their middle lines, one pixel wide; kept, not copied
	 * @param surety see {@link #surety()}
	 */
	public FrameEvidence(final Ridges ridges, final Img<BitType> mask, final Img<BitType> skeleton,
		final double surety) {
		this.appearance = ridges.appearance();
		this.width = ridges.width();
		this.mask = mask;
		this.skeleton = skeleton;
		this.surety = surety;
		z = new byte[width * ridges.height()];
		for (int at = 0; at < z.length; at++)
			z[at] = (byte) Math.max(0, Math.min(255, Math.rint(ridges.z(at) / STEP)));
		places = places(Pixels.bits(skeleton));
		angles = new float[places.length];
		widths = new float[places.length];
		for (int i = 0; i < places.length; i++) {
			angles[i] = (float) ridges.angle(places[i]);
			widths[i] = (float) ridges.lineWidth(places[i]);
		}
	}

	private FrameEvidence(final FrameEvidence whole, final long x, final long y, final int width,
		final int height) {
		appearance = whole.appearance;
		surety = whole.surety;
		this.width = width;
		mask = part(whole.mask, x, y, width, height);
		skeleton = part(whole.skeleton, x, y, width, height);
		z = new byte[width * height];
		for (int row = 0; row < height; row++)
			System.arraycopy(whole.z, (int) ((y + row) * whole.width + x), z, row * width, width);
		places = places(Pixels.bits(skeleton));
		angles = new float[places.length];
		widths = new float[places.length];
		for (int i = 0; i < places.length; i++) {
			final int place = (int) ((places[i] / width + y) * whole.width + places[i] % width + x);
			final int at = Arrays.binarySearch(whole.places, place);
			angles[i] = whole.angles[at];
			widths[i] = whole.widths[at];
		}
	}

	private static Img<BitType> part(final Img<BitType> mask, final long x, final long y,
		final int width, final int height) {
		return Pixels.mask(
			Pixels.bits(
				Views.interval(mask, new long[]{x, y}, new long[]{x + width - 1, y + height - 1})),
			width);
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
		return z.length / width;
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

	/** @return the lines' masks; not to be changed */
	public Img<BitType> mask() {
		return mask;
	}

	/** @return the lines' middle lines, one pixel wide; not to be changed */
	public Img<BitType> skeleton() {
		return skeleton;
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
	 * Ridge strength in units of its local noise, for every pixel, line or not: about 1
	 * on average where there is nothing, seldom above 4.
	 *
	 * @param x column, 0 to below {@link #width()}
	 * @param y row, 0 to below {@link #height()}
	 * @return 0 to 31.9, in steps of an eighth
	 */
	public double z(final int x, final int y) {
		return STEP * (z[y * width + x] & 255);
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
