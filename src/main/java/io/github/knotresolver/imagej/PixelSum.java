package io.github.knotresolver.imagej;

import java.lang.reflect.Array;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.CRC32C;

import ij.ImagePlus;
import ij.ImageStack;

/**
 * Tells whether the pixels of an image are still what they were, whatever was done to it and undone
 * since. Linear in the number of pixels. Of virtual stacks, which no edit
 * changes, only the size counts.
 *
 * @param image the image
 * @param sum a checksum of its pixels
 */
public record PixelSum(ImagePlus image, long sum) {

	private static final int CHUNK = 1 << 14;

	/**
	 * @param image an image
	 * @return how its pixels are now
	 */
	public static PixelSum of(final ImagePlus image) {
		return new PixelSum(image, sum(image));
	}

	/** @return whether the pixels are as they were */
	public boolean isSame() {
		return sum == sum(image);
	}

	private static long sum(final ImagePlus image) {
		final CRC32C crc = new CRC32C();
		// In the order of the machine, numbers are copied as they are.
		final ByteBuffer chunk = ByteBuffer.allocate(Float.BYTES * CHUNK)
			.order(ByteOrder.nativeOrder());
		for (final int size : new int[]{image.getWidth(), image.getHeight(), image.getStackSize(),
			image.getBitDepth()})
			chunk.putInt(size);
		crc.update(chunk.flip());
		final ImageStack stack = image.getStack();
		if (!stack.isVirtual())
			for (int n = 1; n <= stack.size(); n++)
				add(crc, stack.getPixels(n), chunk);
		return crc.getValue();
	}

	private static void add(final CRC32C crc, final Object plane, final ByteBuffer chunk) {
		if (plane instanceof byte[] bytes) {
			crc.update(bytes);
			return;
		}
		final int length = Array.getLength(plane);
		for (int from = 0; from < length; from += CHUNK) {
			final int count = Math.min(CHUNK, length - from);
			final int bytes = put(plane, from, count, chunk.clear());
			crc.update(chunk.position(0).limit(bytes));
		}
	}

	/** @return how many bytes were put */
	private static int put(final Object plane, final int from, final int count,
		final ByteBuffer chunk) {
		if (plane instanceof short[] shorts) {
			chunk.asShortBuffer().put(shorts, from, count);
			return Short.BYTES * count;
		}
		if (plane instanceof float[] floats)
			chunk.asFloatBuffer().put(floats, from, count);
		else
			chunk.asIntBuffer().put((int[]) plane, from, count);
		return Float.BYTES * count;
	}
}
