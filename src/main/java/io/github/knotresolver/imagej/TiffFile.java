
package io.github.knotresolver.imagej;

import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteOrder;
import java.nio.file.Path;

import io.github.knotresolver.model.UserException;

/**
 * Walks the directories of a TIFF file to see whether all the data that they
 * promise are there. ImageJ reads a file that was cut off without a word, and
 * gives back fewer frames.
 */
final class TiffFile {

	private static final int STRIP_OFFSETS = 273, STRIP_COUNTS = 279, TILE_OFFSETS = 324,
		TILE_COUNTS = 325;
	private static final int ENTRY_BYTES = 12, SHORT = 3, BIG_TIFF = 43;
	/** More directories than any movie has: a loop in a damaged file. */
	private static final int MOST_DIRECTORIES = 1_000_000;

	private final RandomAccessFile file;
	private final ByteOrder order;

	private TiffFile(final RandomAccessFile file, final ByteOrder order) {
		this.file = file;
		this.order = order;
	}

	/**
	 * @param path a file that starts like a TIFF
	 * @return whether everything that its directories name lies inside the file
	 * @throws UserException if it is a BigTIFF
	 * @throws IOException if it cannot be read
	 */
	static boolean isComplete(final Path path) throws IOException {
		try (RandomAccessFile file = new RandomAccessFile(path.toFile(), "r")) {
			final TiffFile tiff = new TiffFile(file,
				file.readShort() == 0x4949 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
			if (tiff.unsignedShort() == BIG_TIFF)
				throw new UserException(path.getFileName()
					+ " is a BigTIFF, which ImageJ alone does not read; save it as an ordinary TIFF.");
			return tiff.directoriesAreComplete();
		} catch (final EOFException e) {
			return false;
		}
	}

	private boolean directoriesAreComplete() throws IOException {
		long next = unsignedInt();
		for (int i = 0; next != 0 && i < MOST_DIRECTORIES; i++) {
			file.seek(next);
			final int entries = unsignedShort();
			if (!dataAreComplete(next + 2, entries))
				return false;
			file.seek(next + 2 + (long) ENTRY_BYTES * entries);
			next = unsignedInt();
		}
		return next == 0;
	}

	private boolean dataAreComplete(final long start, final int entries) throws IOException {
		long[] offsets = {}, counts = {};
		for (int i = 0; i < entries; i++) {
			file.seek(start + (long) ENTRY_BYTES * i);
			final int tag = unsignedShort();
			if (tag == STRIP_OFFSETS || tag == TILE_OFFSETS)
				offsets = values();
			if (tag == STRIP_COUNTS || tag == TILE_COUNTS)
				counts = values();
		}
		for (int i = 0; i < Math.min(offsets.length, counts.length); i++)
			if (offsets[i] + counts[i] > file.length())
				return false;
		return true;
	}

	/** The values of the entry whose tag has just been read. */
	private long[] values() throws IOException {
		final boolean isShort = unsignedShort() == SHORT;
		final long count = unsignedInt();
		final int bytes = isShort ? 2 : 4;
		if (count * bytes > 4)
			file.seek(unsignedInt());
		if (count * bytes > file.length())
			throw new EOFException();
		final long[] values = new long[(int) count];
		for (int i = 0; i < values.length; i++)
			values[i] = isShort ? unsignedShort() : unsignedInt();
		return values;
	}

	private int unsignedShort() throws IOException {
		final short value = file.readShort();
		return (order == ByteOrder.BIG_ENDIAN ? value : Short.reverseBytes(value)) & 0xffff;
	}

	private long unsignedInt() throws IOException {
		final int value = file.readInt();
		return (order == ByteOrder.BIG_ENDIAN ? value : Integer.reverseBytes(value)) & 0xffffffffL;
	}
}
