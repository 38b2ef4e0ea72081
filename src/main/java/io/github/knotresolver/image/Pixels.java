
package io.github.knotresolver.image;

import net.imglib2.Cursor;
import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.img.array.ArrayImg;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.img.basictypeaccess.array.LongArray;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;
import net.imglib2.view.Views;

/**
 * Between ImgLib2 images, which stand at the doors of the stages, and the
 * primitive arrays inside. Arrays are row-major: the pixel (x, y) is at
 * {@code y * width + x}. Images may start anywhere; what is made here starts at
 * (0, 0).
 */
public final class Pixels {

	private Pixels() {
	}

	/**
	 * @param image a two-dimensional image
	 * @return its width in pixels
	 */
	public static int width(final RandomAccessibleInterval<?> image) {
		requireTwoDimensions(image);
		return (int) image.dimension(0);
	}

	/**
	 * @param image a two-dimensional image
	 * @return its height in pixels
	 */
	public static int height(final RandomAccessibleInterval<?> image) {
		requireTwoDimensions(image);
		return (int) image.dimension(1);
	}

	/**
	 * @param image a two-dimensional image
	 * @return its values as they are, NaN included
	 */
	public static double[] doubles(final RandomAccessibleInterval<? extends RealType<?>> image) {
		final double[] values = new double[width(image) * height(image)];
		final Cursor<? extends RealType<?>> cursor = Views.flatIterable(image).cursor();
		for (int i = 0; i < values.length; i++)
			values[i] = cursor.next().getRealDouble();
		return values;
	}

	/**
	 * @param values any number
	 * @return the same in single precision
	 */
	public static float[] floats(final double[] values) {
		final float[] floats = new float[values.length];
		for (int i = 0; i < floats.length; i++)
			floats[i] = (float) values[i];
		return floats;
	}

	/**
	 * @param image a two-dimensional image
	 * @return its values; a pixel without a value (NaN) is background and gets
	 *         the lowest value of the image, or 0 if no pixel has one
	 */
	public static float[] floats(final RandomAccessibleInterval<? extends RealType<?>> image) {
		final float[] values = new float[width(image) * height(image)];
		final Cursor<? extends RealType<?>> cursor = Views.flatIterable(image).cursor();
		float lowest = Float.POSITIVE_INFINITY;
		for (int i = 0; i < values.length; i++) {
			values[i] = cursor.next().getRealFloat();
			if (values[i] < lowest)
				lowest = values[i];
		}
		if (lowest == Float.POSITIVE_INFINITY)
			lowest = 0;
		for (int i = 0; i < values.length; i++)
			if (Float.isNaN(values[i]))
				values[i] = lowest;
		return values;
	}

	/**
	 * @param mask a two-dimensional mask
	 * @return its pixels
	 */
	public static boolean[] bits(final RandomAccessibleInterval<BitType> mask) {
		final boolean[] bits = new boolean[width(mask) * height(mask)];
		if (mask instanceof ArrayImg<?, ?> array
			&& array.update(null) instanceof LongArray packed) {
			unpack(packed.getCurrentStorageArray(), bits);
			return bits;
		}
		final Cursor<BitType> cursor = Views.flatIterable(mask).cursor();
		for (int i = 0; i < bits.length; i++)
			bits[i] = cursor.next().get();
		return bits;
	}

	private static void unpack(final long[] packed, final boolean[] bits) {
		for (int word = 0; word < packed.length; word++)
			for (long rest = packed[word]; rest != 0; rest &= rest - 1) {
				final int at = word * Long.SIZE + Long.numberOfTrailingZeros(rest);
				if (at < bits.length)
					bits[at] = true;
			}
	}

	/**
	 * @param values the pixels, row-major; kept, not copied
	 * @param width their number in a row
	 * @return them as an image
	 */
	public static Img<FloatType> image(final float[] values, final int width) {
		return ArrayImgs.floats(values, width, values.length / width);
	}

	/**
	 * @param bits the pixels, row-major
	 * @param width their number in a row
	 * @return them as a mask
	 */
	public static Img<BitType> mask(final boolean[] bits, final int width) {
		final long[] packed = new long[(bits.length + 63) / 64];
		for (int i = 0; i < bits.length; i++)
			if (bits[i])
				packed[i / 64] |= 1L << i;
		return ArrayImgs.bits(new LongArray(packed), width, bits.length / width);
	}

	/**
	 * @param values the pixels, row-major
	 * @param width their number in a row
	 * @param x column; the nearest within the frame is taken
	 * @param y row, likewise
	 * @return the value there, interpolated linearly along both axes
	 */
	public static double between(final float[] values, final int width, final double x,
		final double y) {
		final int height = values.length / width;
		final double u = Math.min(Math.max(x, 0), width - 1);
		final double v = Math.min(Math.max(y, 0), height - 1);
		final int left = (int) u, up = (int) v;
		final int right = Math.min(left + 1, width - 1);
		final int row = up * width, next = Math.min(up + 1, height - 1) * width;
		final double above = values[row + left]
			+ (u - left) * (values[row + right] - values[row + left]);
		final double below = values[next + left]
			+ (u - left) * (values[next + right] - values[next + left]);
		return above + (v - up) * (below - above);
	}

	private static void requireTwoDimensions(final RandomAccessibleInterval<?> image) {
		if (image.numDimensions() != 2)
			throw new IllegalArgumentException(
				"A frame has two dimensions, x and y, but this image has " + image.numDimensions()
					+ "; pass one frame of one channel.");
	}
}
