package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;

/** Writes TIFF files of any kind, damaged ones too, page by page. */
final class TiffBuilder {

	static final int SUBFILE_TYPE = 254, WIDTH = 256, HEIGHT = 257, BITS = 258, COMPRESSION = 259,
		PHOTOMETRIC = 262, DESCRIPTION = 270, STRIP_OFFSETS = 273, ROWS = 278, STRIP_COUNTS = 279,
		PREDICTOR = 317, COLOUR_MAP = 320, TILE_WIDTH = 322, TILE_HEIGHT = 323, TILE_OFFSETS = 324,
		TILE_COUNTS = 325, FORMAT = 339;

	private final boolean big;
	private final List<TreeMap<Integer, long[]>> pages = new ArrayList<>();
	private final List<List<byte[]>> blocks = new ArrayList<>();
	private String description = "";
	private int linkOfLast = -1;

	TiffBuilder(final boolean big) {
		this.big = big;
	}

	TiffBuilder described(final String text) {
		description = text;
		return this;
	}

	/** The last page points to this one as the next. */
	TiffBuilder inACircle(final int page) {
		linkOfLast = page;
		return this;
	}

	/** A page of one strip. */
	TreeMap<Integer, long[]> page(final int width, final int height, final int bits,
		final byte[] pixels) {
		final TreeMap<Integer, long[]> tags = tags(width, height, bits);
		tags.put(ROWS, new long[]{height});
		tags.put(STRIP_OFFSETS, new long[1]);
		tags.put(STRIP_COUNTS, new long[]{pixels.length});
		blocks.add(List.of(pixels));
		return tags;
	}

	/** A page of tiles. */
	TreeMap<Integer, long[]> tiled(final int width, final int height, final int bits,
		final int edge, final List<byte[]> tiles) {
		final TreeMap<Integer, long[]> tags = tags(width, height, bits);
		tags.put(TILE_WIDTH, new long[]{edge});
		tags.put(TILE_HEIGHT, new long[]{edge});
		tags.put(TILE_OFFSETS, new long[tiles.size()]);
		tags.put(TILE_COUNTS, tiles.stream().mapToLong(t -> t.length).toArray());
		blocks.add(tiles);
		return tags;
	}

	private TreeMap<Integer, long[]> tags(final int width, final int height, final int bits) {
		final TreeMap<Integer, long[]> tags = new TreeMap<>();
		tags.put(WIDTH, new long[]{width});
		tags.put(HEIGHT, new long[]{height});
		tags.put(BITS, new long[]{bits});
		tags.put(COMPRESSION, new long[]{1});
		tags.put(PHOTOMETRIC, new long[]{1});
		pages.add(tags);
		return tags;
	}

	Path write(final Path file) throws IOException {
		final ByteBuffer out = ByteBuffer.allocate(1 << 22).order(ByteOrder.LITTLE_ENDIAN);
		out.put((byte) 'I').put((byte) 'I').putShort((short) (big ? 43 : 42));
		if (big)
			out.putShort((short) 8).putShort((short) 0);
		int link = out.position();
		number(out, 0);
		final int[] starts = new int[pages.size()];
		for (int p = 0; p < pages.size(); p++) {
			final TreeMap<Integer, long[]> tags = pages.get(p);
			final long[] offsets = tags
				.get(tags.containsKey(TILE_OFFSETS) ? TILE_OFFSETS : STRIP_OFFSETS);
			for (int b = 0; b < blocks.get(p).size(); b++) {
				offsets[b] = out.position();
				out.put(blocks.get(p).get(b));
			}
			final TreeMap<Integer, Integer> places = new TreeMap<>();
			tags.forEach((tag, values) -> places.put(tag, values(out, tag == COLOUR_MAP, values)));
			final int text = out.position();
			out.put((description + "\0").getBytes(StandardCharsets.UTF_8));
			while (out.position() % 2 == 1)
				out.put((byte) 0);
			starts[p] = out.position();
			number(out, link, starts[p]);
			link = directory(out, tags, places, p == 0 && !description.isEmpty() ? text : -1);
		}
		if (linkOfLast >= 0)
			number(out, link, starts[linkOfLast]);
		final byte[] bytes = new byte[out.position()];
		out.flip().get(bytes);
		return Files.write(file, bytes);
	}

	private static int values(final ByteBuffer out, final boolean isShort, final long[] values) {
		final int place = out.position();
		for (final long value : values)
			if (isShort)
				out.putShort((short) value);
			else
				out.putInt((int) value);
		return place;
	}

	private int directory(final ByteBuffer out, final TreeMap<Integer, long[]> tags,
		final TreeMap<Integer, Integer> places, final int text) {
		final int entries = tags.size() + (text >= 0 ? 1 : 0);
		if (big)
			out.putLong(entries);
		else
			out.putShort((short) entries);
		boolean told = text < 0;
		for (final var tag : tags.entrySet()) {
			if (!told && tag.getKey() > DESCRIPTION) {
				entry(out, DESCRIPTION, 2, description.getBytes(StandardCharsets.UTF_8).length + 1,
					text);
				told = true;
			}
			final long[] values = tag.getValue();
			entry(out, tag.getKey(), tag.getKey() == COLOUR_MAP ? 3 : 4, values.length,
				values.length == 1 ? (int) values[0] : places.get(tag.getKey()));
		}
		final int link = out.position();
		number(out, 0);
		return link;
	}

	private void entry(final ByteBuffer out, final int tag, final int type, final int count,
		final int value) {
		out.putShort((short) tag).putShort((short) type);
		number(out, count);
		number(out, value);
	}

	private void number(final ByteBuffer out, final long value) {
		if (big)
			out.putLong(value);
		else
			out.putInt((int) value);
	}

	private void number(final ByteBuffer out, final int place, final long value) {
		if (big)
			out.putLong(place, value);
		else
			out.putInt(place, (int) value);
	}
}
