package io.github.knotresolver.fuzz;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** What the inputs are drawn from. */
public final class Drawings {

	/** Cells and values that people, spreadsheets and accidents put into tables. */
	private static final String[] ODD = {"", " ", "0", "-1", "-0", "1e308", "-1e308", "1e-320",
		"1.0e+00", "NaN", "Infinity", "1,5", "1.5.2", "99999999999999999999", "2147483647",
		"2147483648", "-2147483648", "0x10", "1_000", "é", "\u00A01\u202F", "\"", "\"\"", "a\"b",
		"[1 5 7]", "[1 5", "1;5;7", "1-3", "5-1", "1-", "1-9999999", "1-2147483647", "false",
		"TRUE", "none", "null", "µm", "Âµm", "nm", "inch", "/", "..", "../..", "a\0b", "CON",
		"otsu", "=1+1", "𝔘", "'", "\\", "&x", "{}", "x".repeat(3000), "1 2", "1,2,3,4", "1,2",
		"0,0,9,9", "-5,-5,3,3", "sep=;", "auto", "free", "paper", "contour", "tip"};

	private static final List<Charset> ENCODINGS = List.of(StandardCharsets.UTF_8,
		StandardCharsets.UTF_8, StandardCharsets.UTF_8, StandardCharsets.UTF_8,
		StandardCharsets.UTF_16, StandardCharsets.UTF_16LE, StandardCharsets.ISO_8859_1,
		Charset.forName("windows-1252"));

	private Drawings() {
	}

	/** Values that nobody expects. */
	public static Arbitrary<String> odd() {
		return Arbitraries.frequencyOf(Tuple.of(8, Arbitraries.of(ODD)),
			Tuple.of(1, Arbitraries.strings().ofMaxLength(6)));
	}

	/** Numbers as they should be, and one in sixty that is odd. */
	static Arbitrary<String> number(final int least, final int most) {
		return Arbitraries.frequencyOf(
			Tuple.of(60, Arbitraries.integers().between(least, most).map(String::valueOf)),
			Tuple.of(1, Arbitraries.doubles().between(least, most).map(String::valueOf)),
			Tuple.of(1, odd()));
	}

	/** A cell of a column. */
	static Arbitrary<String> cell(final String column) {
		return switch (column) {
			case "frame", "filament" -> number(1, 4);
			case "index" -> number(0, 6);
			case "x_px", "y_px", "x", "y", "arc_length", "tangent_angle", "curvature" ->
				number(-5, 70);
			case "unit" -> Arbitraries.oneOf(Arbitraries.of("µm", "pixel", "nm"), odd());
			case "kind" ->
				Arbitraries.oneOf(Arbitraries.of("contour", "through", "tip", "not"), odd());
			default -> odd();
		};
	}

	/** A table with some of the columns, as text in some encoding, perhaps damaged. */
	public static Arbitrary<byte[]> table(final List<String> needed, final List<String> more) {
		final Arbitrary<List<String>> header = Combinators
			.combine(Arbitraries.of(more).list().uniqueElements().ofMaxSize(3),
				Arbitraries.integers().between(0, 9))
			.as((extra, leftOut) -> {
				final List<String> all = new ArrayList<>(needed);
				if (leftOut == 0)
					all.remove(extra.size() % needed.size());
				all.addAll(extra);
				return all;
			});
		return header.flatMap(columns -> {
			final List<Arbitrary<String>> cells = columns.stream().map(Drawings::cell).toList();
			final Arbitrary<List<List<String>>> rows = Combinators.combine(cells)
				.as(list -> (List<String>) new ArrayList<>(list)).list().ofMaxSize(8);
			return Combinators
				.combine(rows, Arbitraries.of(",", ",", ",", ";", "\t"),
					Arbitraries.of("\n", "\n", "\r\n", "\r"),
					Arbitraries.of("", "", "\uFEFF", "sep=;\n"), Arbitraries.of(ENCODINGS), edits())
				.as((list, separator, end, first, encoding,
					edits) -> damaged((first + String.join(separator, columns) + end
						+ String.join(end,
							list.stream().map(r -> String.join(separator, r)).toList())
						+ end).getBytes(encoding), edits));
		});
	}

	/** Damage: where, what, how much. Most inputs have none or little. */
	public static Arbitrary<List<int[]>> edits() {
		final Arbitrary<int[]> edit = Combinators
			.combine(Arbitraries.integers().between(0, 6), Arbitraries.integers().between(0, 9999),
				Arbitraries.integers().between(0, 255), Arbitraries.integers().between(1, 9))
			.as((kind, at, value, length) -> new int[]{kind, at, value, length});
		return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.just(List.of())),
			Tuple.of(2, edit.list().ofMinSize(1).ofMaxSize(3)));
	}

	/** Does the damage. */
	public static byte[] damaged(final byte[] bytes, final List<int[]> edits) {
		byte[] now = bytes;
		for (final int[] e : edits)
			if (now.length > 0)
				now = damaged(now, e[0], e[1] % now.length, (byte) e[2], e[3]);
		return now;
	}

	private static byte[] damaged(final byte[] bytes, final int kind, final int at,
		final byte value, final int length) {
		final int end = Math.min(bytes.length, at + length);
		switch (kind) {
			case 0 : // cut off
				return Arrays.copyOf(bytes, at);
			case 1 : // a piece is missing
				return joined(Arrays.copyOf(bytes, at),
					Arrays.copyOfRange(bytes, end, bytes.length));
			case 2 : // a piece comes twice
				return joined(Arrays.copyOf(bytes, end),
					Arrays.copyOfRange(bytes, at, bytes.length));
			case 3 : // a piece is overwritten
				final byte[] filled = bytes.clone();
				Arrays.fill(filled, at, end, value);
				return filled;
			case 4 : // a byte is put in
				return joined(joined(Arrays.copyOf(bytes, at), new byte[]{value}),
					Arrays.copyOfRange(bytes, at, bytes.length));
			default : // a bit is flipped
				final byte[] flipped = bytes.clone();
				flipped[at] ^= (byte) (1 << length % 8);
				return flipped;
		}
	}

	private static byte[] joined(final byte[] a, final byte[] b) {
		final byte[] both = Arrays.copyOf(a, a.length + b.length);
		System.arraycopy(b, 0, both, a.length, b.length);
		return both;
	}

	/** Bytes as a message can show them. */
	public static String shown(final byte[] bytes) {
		final String text = new String(bytes, StandardCharsets.ISO_8859_1);
		return "'"
			+ (text.length() > 1500 ? text.substring(0, 1500) + "..." : text)
				.replaceAll("[^\\x20-\\x7E\\n]", "?")
			+ "', " + bytes.length + " bytes, in Base64 "
			+ (bytes.length > 3000
				? "too long, but kept as " + kept(bytes)
				: java.util.Base64.getEncoder().encodeToString(bytes));
	}

	/** A file that outlives the test, so that a failure can be repeated. */
	private static Path kept(final byte[] bytes) {
		try {
			return Files.write(Files.createTempFile("knotresolver-fuzz-", ".tif"), bytes);
		} catch (final IOException e) {
			throw new UncheckedIOException(e);
		}
	}
}
