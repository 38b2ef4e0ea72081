package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;

import ij.ImagePlus;
import ij.io.Opener;
import io.github.knotresolver.model.UserException;

/** Pictures whose readers fill up in silence what was cut off: JPEG, PNG and PGM. */
final class PictureEnd {

	/** Programs may add something of theirs behind the end. */
	private static final int LOOKED_AT = 1 << 16;
	private static final byte[] JPEG = {(byte) 0xff, (byte) 0xd9}, PNG = {'I', 'E', 'N', 'D'};

	private PictureEnd() {
	}

	/**
	 * @param file a file
	 * @param type its kind, as ImageJ counts them
	 * @param image what was read of it
	 * @throws UserException if its end is missing
	 * @throws IOException if it cannot be read
	 */
	static void require(final Path file, final int type, final ImagePlus image) throws IOException {
		try (FileChannel channel = FileChannel.open(file)) {
			final double pixels = (double) image.getWidth() * image.getHeight()
				* Math.max(1, image.getBitDepth() / 8);
			if (type == Opener.JPEG && !hasEnd(channel, JPEG)
				|| type == Opener.PNG && !hasEnd(channel, PNG)
				|| type == Opener.PGM && channel.size() < pixels)
				throw new UserException(file
					+ " is cut off: the file ends before its last pixel; copy the file again from its source.");
		}
	}

	private static boolean hasEnd(final FileChannel channel, final byte[] mark) throws IOException {
		final int size = (int) Math.min(LOOKED_AT, channel.size());
		final ByteBuffer tail = ByteBuffer.allocate(size);
		while (tail.hasRemaining()
			&& channel.read(tail, channel.size() - size + tail.position()) >= 0)
			continue;
		for (int i = tail.position() - mark.length; i >= 0; i--)
			if (tail.slice(i, mark.length).equals(ByteBuffer.wrap(mark)))
				return true;
		return false;
	}
}
