package io.github.knotresolver.io;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The blocks of a GIF file, walked from its first to its last: readers take a file
 * that was cut off for one with fewer frames. See the specification of GIF89a.
 */
public final class GifBlocks {

	private static final int HEADER = 10, IMAGE = 0x2c, EXTENSION = 0x21, TRAILER = 0x3b;
	private static final int TABLE = 0x80, TABLE_SIZE = 7, COLOUR_BYTES = 3, PLACE = 8;

	private final DataInputStream in;
	private int frames;

	private GifBlocks(final DataInputStream in) {
		this.in = in;
	}

	/**
	 * @param file a GIF file
	 * @return how many frames it has
	 * @throws EOFException if it ends before its last block
	 * @throws IOException if it cannot be read
	 */
	public static int frames(final Path file) throws IOException {
		try (DataInputStream in = new DataInputStream(
			new BufferedInputStream(Files.newInputStream(file)))) {
			final GifBlocks blocks = new GifBlocks(in);
			blocks.walk();
			return blocks.frames;
		}
	}

	private void walk() throws IOException {
		in.skipNBytes(HEADER);
		final int flags = in.readUnsignedByte();
		in.skipNBytes(2);
		table(flags);
		for (int block = in.readUnsignedByte(); block != TRAILER; block = in.readUnsignedByte())
			if (block == IMAGE) {
				in.skipNBytes(PLACE);
				table(in.readUnsignedByte());
				in.skipNBytes(1);
				data();
				frames++;
			} else if (block == EXTENSION) {
				in.skipNBytes(1);
				data();
			} else if (block != 0)
				throw new EOFException("There is no block of kind " + block + ".");
	}

	private void table(final int flags) throws IOException {
		if ((flags & TABLE) != 0)
			in.skipNBytes((long) COLOUR_BYTES << (flags & TABLE_SIZE) + 1);
	}

	/** Pieces with their lengths, up to one of length 0. */
	private void data() throws IOException {
		for (int length = in.readUnsignedByte(); length != 0; length = in.readUnsignedByte())
			in.skipNBytes(length);
	}
}
