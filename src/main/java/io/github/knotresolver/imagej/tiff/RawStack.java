package io.github.knotresolver.imagej.tiff;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.stream.IntStream;

import ij.VirtualStack;
import ij.process.ByteProcessor;
import ij.process.FloatProcessor;
import ij.process.ImageProcessor;
import ij.process.ShortProcessor;
import io.github.knotresolver.model.UserException;

/**
 * The frames of a TIFF without compression, each read from the file when it is asked for, so
 * that a movie may be larger than memory. The file is open only while it is read.
 */
final class RawStack extends VirtualStack {

	private static final int BYTE = 8, SHORT = 16, FLOAT = 32, SIGNED_SHIFT = 1 << 15;

	private final Path path;
	private final TiffPage page;
	private final ByteOrder order;
	private final long[] offsets;

	/**
	 * @param path the file
	 * @param page any of its frames, which all are of one kind, {@link #canRead}
	 * @param order of the bytes in a number
	 * @param offsets where the pixels of each frame begin
	 */
	RawStack(final Path path, final TiffPage page, final ByteOrder order, final long[] offsets) {
		super((int) page.width(), (int) page.height());
		this.path = path;
		this.page = page;
		this.order = order;
		this.offsets = offsets.clone();
		setBitDepth(page.bits());
	}

	/** @return whether pages like this one are read here: grey values of 8, 16 or 32 bit in a row */
	static boolean canRead(final TiffPage page) {
		final boolean number = page.bits() == FLOAT
			? page.format() == TiffPage.FLOAT
			: page.bits() == SHORT && page.format() <= TiffPage.SIGNED
				|| page.bits() == BYTE && page.format() == TiffPage.UNSIGNED;
		return number && page.compression() == 1 && page.samples() == 1 && !page.isTiled()
			&& page.photometric() == 1 && isInARow(page);
	}

	private static boolean isInARow(final TiffPage page) {
		final long[] starts = page.values(TiffPage.STRIP_OFFSETS),
			lengths = page.values(TiffPage.STRIP_COUNTS);
		for (int i = 1; i < starts.length; i++)
			if (lengths.length != starts.length || starts[i] != starts[i - 1] + lengths[i - 1])
				return false;
		return starts.length > 0;
	}

	/** @return where the pixels of each frame begin: of one page in a row, or of several pages */
	static long[] offsets(final List<TiffPage> pages, final int frames) {
		final long[] offsets = new long[frames];
		for (int i = 0; i < frames; i++)
			offsets[i] = pages.size() == frames
				? pages.get(i).values(TiffPage.STRIP_OFFSETS)[0]
				: pages.get(0).values(TiffPage.STRIP_OFFSETS)[0] + i * (long) pages.get(0).bytes();
		return offsets;
	}

	/** @return the same frames in another order: which comes at each place, from 0 */
	RawStack ordered(final int[] places) {
		return new RawStack(path, page, order,
			IntStream.of(places).mapToLong(i -> offsets[i]).toArray());
	}

	@Override
	public int size() {
		return offsets == null ? 0 : offsets.length;
	}

	@Override
	public int getSize() {
		return size();
	}

	@Override
	public String getSliceLabel(final int n) {
		return null;
	}

	@Override
	public Object getPixels(final int n) {
		return getProcessor(n).getPixels();
	}

	@Override
	public ImageProcessor getProcessor(final int n) {
		if (n < 1 || n > offsets.length)
			throw new IllegalArgumentException("There is no frame " + n + " in " + path + ".");
		final ByteBuffer bytes = bytes(n);
		final int size = getWidth() * getHeight();
		if (page.bits() == BYTE)
			return new ByteProcessor(getWidth(), getHeight(), bytes.array());
		if (page.bits() == FLOAT) {
			final float[] pixels = new float[size];
			bytes.asFloatBuffer().get(pixels);
			return new FloatProcessor(getWidth(), getHeight(), pixels);
		}
		final short[] pixels = new short[size];
		bytes.asShortBuffer().get(pixels);
		if (page.format() == TiffPage.SIGNED)
			for (int i = 0; i < size; i++)
				pixels[i] += SIGNED_SHIFT;
		return new ShortProcessor(getWidth(), getHeight(), pixels, null);
	}

	private ByteBuffer bytes(final int n) {
		final ByteBuffer bytes = ByteBuffer.allocate((int) page.bytes()).order(order);
		try (FileChannel file = FileChannel.open(path, StandardOpenOption.READ)) {
			long at = offsets[n - 1];
			while (bytes.hasRemaining()) {
				final int read = file.read(bytes, at);
				if (read < 0)
					throw TiffStructure.cutOff(path);
				at += read;
			}
			return bytes.flip();
		} catch (final IOException e) {
			throw new UserException("Frame " + n + " of " + path + " cannot be read: "
				+ e.getMessage() + "; leave the file where it is until the movie is resolved.", e);
		}
	}
}
