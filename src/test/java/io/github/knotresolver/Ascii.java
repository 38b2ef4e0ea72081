
package io.github.knotresolver;

import java.util.ArrayList;
import java.util.List;

import net.imglib2.Cursor;
import net.imglib2.img.Img;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.type.logic.BitType;

/** Masks a reader can draw: {@code '#'} is filament, anything else is not. */
public final class Ascii {

	private Ascii() {
	}

	/**
	 * @param rows rows of equal length, separated by line breaks
	 * @return the mask, x to the right, y down
	 */
	public static Img<BitType> mask(final String rows) {
		final List<String> lines = rows.strip().lines().map(String::strip).toList();
		final int width = lines.get(0).length();
		final Img<BitType> mask = ArrayImgs.bits(width, lines.size());
		final Cursor<BitType> cursor = mask.localizingCursor();
		while (cursor.hasNext()) {
			cursor.fwd();
			final String line = lines.get(cursor.getIntPosition(1));
			if (line.length() != width)
				throw new IllegalArgumentException("Row " + cursor.getIntPosition(1) + " has "
					+ line.length() + " columns, not " + width);
			cursor.get().set(line.charAt(cursor.getIntPosition(0)) == '#');
		}
		return mask;
	}

	/**
	 * @param mask a mask
	 * @return its drawing, to compare and to read
	 */
	public static String draw(final Img<BitType> mask) {
		final List<String> lines = new ArrayList<>();
		for (int y = 0; y < mask.dimension(1); y++) {
			final StringBuilder line = new StringBuilder();
			for (int x = 0; x < mask.dimension(0); x++)
				line.append(mask.getAt(x, y).get() ? '#' : '.');
			lines.add(line.toString());
		}
		return String.join("\n", lines);
	}
}
