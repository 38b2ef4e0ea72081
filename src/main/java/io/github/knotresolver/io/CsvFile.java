
package io.github.knotresolver.io;

import java.io.BufferedWriter;
import java.io.FilterWriter;
import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVPrinter;
import org.apache.commons.csv.CSVRecord;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.CellText;
import io.github.knotresolver.progress.Cancellation;

/**
 * CSV as this program writes it (UTF-8, commas, line feeds) and as others do: with
 * semicolons or tabs, Excel's line {@code sep=;}, UTF-16 or Windows-1252, spaces of
 * any width around cells.
 */
final class CsvFile {

	private static final CSVFormat WRITE = CSVFormat.DEFAULT.builder().setRecordSeparator("\n")
		.get();
	private static final CSVFormat READ = CSVFormat.DEFAULT.builder().setTrim(true)
		.setIgnoreEmptyLines(true).get();
	private static final String SEPARATOR_LINE = "sep=";
	private static final char[] DELIMITERS = {',', ';', '\t'};

	private CsvFile() {
	}

	/** Asks before every block whether the work is to stop. */
	private static final class AskingWriter extends FilterWriter {

		AskingWriter(final Writer out) {
			super(out);
		}

		@Override
		public void write(final char[] text, final int from, final int length) throws IOException {
			Cancellation.check();
			super.write(text, from, length);
		}
	}

	/** @return a printer into a new file, to be closed; may be cancelled */
	static CSVPrinter create(final Path file, final String... header) throws IOException {
		final CSVPrinter printer = new CSVPrinter(new BufferedWriter(
			new AskingWriter(Files.newBufferedWriter(file, StandardCharsets.UTF_8))), WRITE);
		if (header.length > 0)
			printer.printRecord((Object[]) header);
		return printer;
	}

	/**
	 * @return all rows, the header among them, without empty lines
	 * @throws UserException if the file is not readable text
	 */
	static List<Row> read(final Path file) {
		if (!Files.isRegularFile(file))
			throw new UserException("There is no file " + file + "; check the path.");
		try {
			final String text = TextDecoder.decode(Files.readAllBytes(file));
			if (text.lines().findFirst().orElse("").indexOf('\0') >= 0)
				throw new UserException(
					file + " is no text, but a CSV file is; export the table as CSV.");
			return rows(file, text);
		} catch (final IOException e) {
			throw new UserException(file + " cannot be read: " + e.getMessage() + ".", e);
		}
	}

	private static List<Row> rows(final Path file, final String text) throws IOException {
		final String first = text.lines().findFirst().orElse("");
		final Optional<Character> told = separator(first);
		final char delimiter = told.orElseGet(() -> delimiter(text));
		final List<Row> rows = new ArrayList<>();
		try (CSVParser parser = READ.builder().setDelimiter(delimiter).get()
			.parse(new StringReader(text))) {
			for (final CSVRecord record : parser) {
				Cancellation.check();
				if (told.isEmpty() || record.getRecordNumber() > 1)
					rows.add(Row.of((int) parser.getCurrentLineNumber(), record));
			}
			return rows;
		} catch (final IOException | UncheckedIOException e) {
			throw new UserException(file + " is damaged after line "
				+ (rows.isEmpty() ? 0 : rows.get(rows.size() - 1).line())
				+ ": a quotation mark is missing or stands inside a cell; mend that line.", e);
		}
	}

	/** What Excel writes first for readers of another country. */
	private static Optional<Character> separator(final String line) {
		final String text = CellText.clean(line.replace("\"", ""));
		return text.length() == SEPARATOR_LINE.length() + 1
			&& text.regionMatches(true, 0, SEPARATOR_LINE, 0, SEPARATOR_LINE.length())
				? Optional.of(text.charAt(SEPARATOR_LINE.length()))
				: text.equalsIgnoreCase(SEPARATOR_LINE) && line.endsWith("\t")
					? Optional.of('\t')
					: Optional.empty();
	}

	/**
	 * What parts the cells of the first line: the semicolon or tab if there is one
	 * outside of quotation marks, for commas are then decimal commas.
	 */
	private static char delimiter(final String text) {
		final String line = text.lines().filter(l -> !l.isBlank()).findFirst().orElse("")
			.replaceAll("\"[^\"]*\"", "");
		for (int i = DELIMITERS.length - 1; i > 0; i--)
			if (line.indexOf(DELIMITERS[i]) >= 0)
				return DELIMITERS[i];
		return DELIMITERS[0];
	}

	/**
	 * A row of a CSV file.
	 *
	 * @param line 1-based line of the file where it ends
	 * @param cells without spaces of any kind around them
	 */
	record Row(int line, List<String> cells) {

		Row {
			cells = List.copyOf(cells);
		}

		static Row of(final int line, final CSVRecord record) {
			return new Row(line, record.stream().map(CellText::clean).toList());
		}

		/** @return the number of cells */
		int size() {
			return cells.size();
		}

		/** @return the text of cell i, from 0 */
		String get(final int i) {
			return cells.get(i);
		}

		/**
		 * @return the text of cell i, with a dot if it is one number with a decimal comma: a
		 *         comma that parts cells is not in a cell
		 */
		String number(final int i) {
			return CellText.withDot(get(i));
		}
	}

	/**
	 * Text of unknown encoding: UTF-8, UTF-16 with a mark or told by its zeros, else
	 * Windows-1252, which has a character for nearly every byte.
	 */
	private static final class TextDecoder {

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
}
