package io.github.knotresolver.imagej.tiff;

import java.io.EOFException;
import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import io.github.knotresolver.model.UserException;

/**
 * The directories of a TIFF or BigTIFF file, read without trust: a list that runs
 * in a circle, and data beyond the end of the file, are found before anybody
 * decodes a pixel. Linear in the size of the file, whatever is in it.
 */
public final class TiffStructure {

	private static final int CLASSIC = 42, BIG = 43, LITTLE = 0x4949, BIG_ENDIAN = 0x4d4d;
	private static final int[] TYPE_BYTES = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8,
		8};
	private static final String CIRCLE = "its list of images runs in a circle";
	private static final int ASCII = 2, RATIONAL = 5;
	/** Values that several directories share may be read several times. */
	private static final long SHARED = 4, ALWAYS = 1 << 20;

	private final FileChannel file;
	private final Path path;
	private ByteOrder order = ByteOrder.LITTLE_ENDIAN;
	private boolean big;
	private long budget;
	private final List<TiffPage> pages = new ArrayList<>();

	private TiffStructure(final Path path, final FileChannel file) throws IOException {
		this.path = path;
		this.file = file;
		this.budget = SHARED * file.size() + ALWAYS;
	}

	/**
	 * @param path a file
	 * @return whether it begins as TIFF and BigTIFF do
	 * @throws IOException if it cannot be read
	 */
	public static boolean isTiff(final Path path) throws IOException {
		try (FileChannel file = FileChannel.open(path)) {
			final TiffStructure tiff = new TiffStructure(path, file);
			tiff.header();
			return true;
		} catch (final EOFException | UserException e) {
			return false;
		}
	}

	/**
	 * @param path a TIFF or BigTIFF file
	 * @return its structure
	 * @throws UserException if it is damaged or cut off, in one sentence
	 * @throws IOException if it cannot be read
	 */
	public static TiffStructure read(final Path path) throws IOException {
		try (FileChannel file = FileChannel.open(path)) {
			final TiffStructure tiff = new TiffStructure(path, file);
			tiff.directories(tiff.header());
			for (final TiffPage page : tiff.pages)
				tiff.requireData(page);
			return tiff;
		} catch (final EOFException | BufferUnderflowException e) {
			throw cutOff(path);
		}
	}

	static UserException cutOff(final Path path) {
		return new UserException(path
			+ " is cut off: the file ends before its last frame; copy the file again from its source.");
	}

	static UserException damaged(final Path path, final String why) {
		return new UserException(
			path + " is damaged: " + why + "; copy the file again from its source.");
	}

	/** @return all images in their order, those that are thumbnails among them; at least one */
	List<TiffPage> pages() {
		return List.copyOf(pages);
	}

	/** @return the order of the bytes in a number */
	ByteOrder order() {
		return order;
	}

	/** @return whether it is a BigTIFF */
	boolean isBig() {
		return big;
	}

	Path path() {
		return path;
	}

	/** @return where the first directory is */
	private long header() throws IOException {
		final ByteBuffer head = bytes(0, 8);
		final int mark = head.getShort(0) & 0xffff;
		if (mark != LITTLE && mark != BIG_ENDIAN)
			throw damaged(path, "it does not begin as a TIFF file does");
		order = mark == LITTLE ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
		final int version = head.order(order).getShort(2) & 0xffff;
		big = version == BIG;
		if (!big && version != CLASSIC)
			throw damaged(path, "it does not begin as a TIFF file does");
		return big ? bytes(8, 8).getLong() : head.getInt(4) & 0xffffffffL;
	}

	private void directories(final long first) throws IOException {
		long next = first;
		final Set<Long> seen = new HashSet<>();
		while (next != 0) {
			if (!seen.add(next))
				throw damaged(path, CIRCLE);
			final int header = big ? 8 : 2, size = big ? 20 : 12, link = big ? 8 : 4;
			final ByteBuffer count = bytes(next, header);
			final long entries = big ? count.getLong() : count.getShort() & 0xffff;
			if (entries <= 0 || entries > 0xffff)
				throw damaged(path, "image " + (pages.size() + 1) + " has no description");
			final ByteBuffer table = bytes(next + header, (int) entries * size + link);
			final Map<Integer, long[]> values = new HashMap<>();
			String description = "";
			for (int i = 0; i < entries; i++) {
				final ByteBuffer entry = table.slice(i * size, size).order(order);
				final int tag = entry.getShort() & 0xffff;
				requireCount(entry);
				if (tag == TiffPage.DESCRIPTION)
					description = text(entry);
				else if (isWanted(tag))
					values.put(tag, values(entry));
			}
			pages.add(new TiffPage(values, description));
			table.position((int) entries * size);
			next = big ? table.getLong() : table.getInt() & 0xffffffffL;
		}
		if (pages.isEmpty())
			throw damaged(path, "it names no image");
	}

	/** Others believe a count of any kind, and read so many numbers wherever they are. */
	private void requireCount(final ByteBuffer entry) throws IOException {
		final int at = entry.position() + 2;
		final long count = big ? entry.getLong(at) : entry.getInt(at) & 0xffffffffL;
		if (count < 0 || count > file.size())
			throw new EOFException();
	}

	private static boolean isWanted(final int tag) {
		return tag >= TiffPage.SUBFILE_TYPE && tag <= TiffPage.SAMPLE_FORMAT;
	}

	private String text(final ByteBuffer entry) throws IOException {
		if (entry.getShort() != ASCII)
			return "";
		final ByteBuffer content = content(entry, 1);
		final byte[] text = new byte[content.remaining()];
		content.get(text);
		return new String(text, StandardCharsets.UTF_8).replaceAll("\0+$", "");
	}

	private long[] values(final ByteBuffer entry) throws IOException {
		final int type = entry.getShort() & 0xffff;
		final int bytes = type < TYPE_BYTES.length ? TYPE_BYTES[type] : 0;
		if (bytes == 0)
			return new long[0];
		final ByteBuffer content = content(entry, bytes);
		final int each = type == RATIONAL ? 4 : bytes;
		final long[] values = new long[content.remaining() / each];
		for (int i = 0; i < values.length; i++)
			values[i] = switch (each) {
				case 1 -> content.get() & 0xff;
				case 2 -> content.getShort() & 0xffff;
				case 4 -> content.getInt() & 0xffffffffL;
				default -> content.getLong();
			};
		return values;
	}

	/** The bytes of an entry's values, which stand in it or elsewhere. */
	private ByteBuffer content(final ByteBuffer entry, final int bytes) throws IOException {
		final long count = big ? entry.getLong() : entry.getInt() & 0xffffffffL;
		final int inside = big ? 8 : 4;
		final int size = Math.toIntExact(Math.min(Integer.MAX_VALUE, count * bytes));
		if (size <= inside)
			return entry.slice(entry.position(), size).order(order);
		return bytes(big ? entry.getLong() : entry.getInt() & 0xffffffffL, size);
	}

	private ByteBuffer bytes(final long position, final int size) throws IOException {
		if (position < 0 || position + size > file.size())
			throw new EOFException();
		budget -= size;
		if (budget < 0)
			throw damaged(path, CIRCLE);
		final ByteBuffer bytes = ByteBuffer.allocate(size).order(order);
		while (bytes.hasRemaining())
			if (file.read(bytes, position + bytes.position()) < 0)
				throw new EOFException();
		return bytes.flip();
	}

	/** Everything that the directory names lies inside the file, and is as much as it should. */
	private void requireData(final TiffPage page) throws IOException {
		if (page.width() <= 0 || page.height() <= 0)
			throw damaged(path, "an image has no size");
		final boolean tiled = page.isTiled();
		final long[] offsets = page.values(tiled ? TiffPage.TILE_OFFSETS : TiffPage.STRIP_OFFSETS),
			counts = page.values(tiled ? TiffPage.TILE_COUNTS : TiffPage.STRIP_COUNTS);
		if (offsets.length == 0)
			throw damaged(path, "an image has no pixels");
		double sum = 0;
		for (int i = 0; i < Math.min(offsets.length, counts.length); i++) {
			if (offsets[i] < 0 || counts[i] < 0 || offsets[i] + counts[i] > file.size())
				throw cutOff(path);
			sum += counts[i];
		}
		final boolean told = counts.length == offsets.length;
		if (page.compression() == 1 && told && sum < page.bytes()
			|| page.compression() == 1 && !told && offsets[0] + page.bytes() > file.size())
			throw cutOff(path);
	}
}
