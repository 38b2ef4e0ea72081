package io.github.knotresolver.io;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;

/**
 * Text of unknown encoding: UTF-8, UTF-16 with a mark or told by its zeros, else
 * Windows-1252, which has a character for nearly every byte.
 */
final class TextDecoder {

	private static final Charset WINDOWS = Charset.forName("windows-1252");
	private static final int LOOKED_AT = 1000;
	/** Of Latin text in UTF-16 nearly every second byte is 0; a fourth is enough. */
	private static final int MOST_LATIN = 4;

	private TextDecoder() {
	}

	/**
	 * @param bytes of a text file
	 * @return its text, without a byte order mark
	 */
	static String decode(final byte[] bytes) {
		final String text = new String(bytes, charset(bytes));
		return text.startsWith("\uFEFF") ? text.substring(1) : text;
	}

	private static Charset charset(final byte[] bytes) {
		final int looked = Math.min(bytes.length, LOOKED_AT);
		if (startsWith(bytes, 0xFF, 0xFE) || zeros(bytes, 1) > looked / MOST_LATIN)
			return StandardCharsets.UTF_16LE;
		if (startsWith(bytes, 0xFE, 0xFF) || zeros(bytes, 0) > looked / MOST_LATIN)
			return StandardCharsets.UTF_16BE;
		try {
			StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes));
			return StandardCharsets.UTF_8;
		} catch (final CharacterCodingException e) {
			return WINDOWS;
		}
	}

	private static boolean startsWith(final byte[] bytes, final int first, final int second) {
		return bytes.length > 1 && (bytes[0] & 0xff) == first && (bytes[1] & 0xff) == second;
	}

	/** How many zeros stand at even (0) or odd (1) places of the beginning. */
	private static int zeros(final byte[] bytes, final int parity) {
		int zeros = 0;
		for (int i = parity; i < Math.min(bytes.length, LOOKED_AT); i += 2)
			if (bytes[i] == 0)
				zeros++;
		return zeros;
	}
}
