package io.github.knotresolver.fuzz;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.zip.Deflater;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** TIFF stacks of a few pixels, of all kinds, with directories that say odd things. */
final class DrawnTiff {

	private static final int[] TAGS = {256, 257, 258, 259, 262, 270, 273, 277, 278, 279, 282, 284,
		296, 317, 320, 322, 339, 50838, 50839, 0, 65535};

	/** Offsets and counts that break naive readers. */
	private static final int[] VALUES = {0, 1, 2, 7, 8, 16, 32, 64, 255, 65535, 1 << 20, 1 << 30,
		Integer.MAX_VALUE, -1, Integer.MIN_VALUE, 32773, 50000, 34712};

	private DrawnTiff() {
	}

	/** A number that is written over one of a directory: which page, entry and field. */
	private record Lie(int page, int entry, int field, int value) {
	}

	private record Kind(int width, int height, int pages, int bits, int compression,
		boolean littleEndian, int format, String description) {
	}

	static Arbitrary<byte[]> any() {
		final Arbitrary<Kind> kinds = Combinators.combine(Arbitraries.integers().between(1, 24),
			Arbitraries.integers().between(1, 24), Arbitraries.integers().between(1, 4),
			Arbitraries.of(8, 8, 8, 16, 16, 16, 16, 1, 32, 64),
			Arbitraries.of(1, 1, 1, 1, 8, 8, 8, 5, 32773, 32946, 7), Arbitraries.of(true, false),
			Arbitraries.of(1, 1, 1, 1, 1, 2, 3),
			Arbitraries.of("", "", "", "", "", "", "ImageJ=1.54p\nimages=3\nframes=3\n",
				"ImageJ=1.54p\nimages=9999999\nslices=7\nunit=\\u00B5m\nfinterval=1e308\n",
				"ImageJ=1.11a\nimages=-4\nspacing=NaN\nmin=a\n",
				"<?xml version=\"1.0\"?><OME><Image><Pixels SizeX=\"3\" DimensionOrder=\"XYZCT\" "
					+ "PhysicalSizeX=\"x\" TimeIncrement=\"-1\" SizeT=\"99999999\"/></Image></OME>"))
			.as(Kind::new);
		final Arbitrary<List<Lie>> lies = Combinators
			.combine(Arbitraries.integers().between(0, 3), Arbitraries.integers().between(0, 15),
				Arbitraries.integers().between(0, 4), Arbitraries.integers().between(0, 999))
			.as(Lie::new).list().ofMinSize(1).ofMaxSize(3);
		final Arbitrary<List<Lie>> some = Arbitraries
			.frequencyOf(Tuple.of(1, Arbitraries.just(List.of())), Tuple.of(1, lies));
		return Combinators.combine(kinds, some, Drawings.edits())
			.as((kind, told, edits) -> Drawings.damaged(file(kind, told), edits));
	}

	private static byte[] file(final Kind k, final List<Lie> lies) {
		final byte[] strip = strip(k);
		final byte[] text = (k.description + "\0")
			.getBytes(java.nio.charset.StandardCharsets.UTF_8);
		final int entries = 11, directory = 2 + 12 * entries + 4;
		final int page = directory + text.length + strip.length;
		final ByteBuffer out = ByteBuffer.allocate(8 + k.pages * page)
			.order(k.littleEndian ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
		out.put(k.littleEndian ? new byte[]{'I', 'I'} : new byte[]{'M', 'M'});
		out.putShort((short) 42).putInt(8);
		for (int p = 0; p < k.pages; p++) {
			final int at = out.position();
			final int[][] all = {{256, 4, 1, k.width}, {257, 4, 1, k.height}, {258, 4, 1, k.bits},
				{259, 4, 1, k.compression}, {262, 4, 1, 1}, {270, 2, text.length, at + directory},
				{273, 4, 1, at + directory + text.length}, {277, 4, 1, 1}, {278, 4, 1, k.height},
				{279, 4, 1, strip.length}, {339, 4, 1, k.format}};
			int next = p == k.pages - 1 ? 0 : at + page;
			for (final Lie lie : lies)
				if (lie.page == p && lie.entry < entries)
					all[lie.entry][lie.field % 4] = lie.field == 0
						? TAGS[lie.value % TAGS.length]
						: VALUES[lie.value % VALUES.length];
				else if (lie.page == p)
					next = lie.value % 3 == 0 ? at : VALUES[lie.value % VALUES.length];
			out.putShort((short) entries);
			for (final int[] e : all)
				out.putShort((short) e[0]).putShort((short) e[1]).putInt(e[2]).putInt(e[3]);
			out.putInt(next).put(text).put(strip);
		}
		return out.array();
	}

	private static byte[] strip(final Kind k) {
		final byte[] raw = new byte[(k.width * k.height * k.bits + 7) / 8];
		for (int i = 0; i < raw.length; i++)
			raw[i] = (byte) (i * 37);
		if (k.compression != 8 && k.compression != 32946)
			return raw;
		final Deflater deflater = new Deflater();
		deflater.setInput(raw);
		deflater.finish();
		final ByteArrayOutputStream packed = new ByteArrayOutputStream();
		final byte[] buffer = new byte[512];
		while (!deflater.finished())
			packed.write(buffer, 0, deflater.deflate(buffer));
		deflater.end();
		return packed.toByteArray();
	}

}
