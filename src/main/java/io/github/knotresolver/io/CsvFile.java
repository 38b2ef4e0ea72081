
package io.github.knotresolver.io;

import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVPrinter;
import org.apache.commons.csv.CSVRecord;

import io.github.knotresolver.model.UserException;

/** CSV as this program writes and reads it: UTF-8, commas, line feeds. */
final class CsvFile {

	private static final CSVFormat WRITE = CSVFormat.DEFAULT.builder().setRecordSeparator("\n")
		.get();
	private static final CSVFormat READ = CSVFormat.DEFAULT.builder().setTrim(true)
		.setIgnoreEmptyLines(true).get();

	private CsvFile() {
	}

	/** @return a printer into a new file, to be closed */
	static CSVPrinter create(final Path file, final String... header) throws IOException {
		final CSVPrinter printer = new CSVPrinter(
			Files.newBufferedWriter(file, StandardCharsets.UTF_8), WRITE);
		if (header.length > 0)
			printer.printRecord((Object[]) header);
		return printer;
	}

	/**
	 * @return all records, the header among them
	 * @throws UserException if the file is not readable text
	 */
	static List<CSVRecord> read(final Path file) {
		if (!Files.isRegularFile(file))
			throw new UserException("There is no file " + file + "; check the path.");
		try (Reader reader = Files.newBufferedReader(file, StandardCharsets.UTF_8);
			CSVParser parser = READ.parse(reader)) {
			return parser.getRecords();
		} catch (final IOException | UncheckedIOException e) {
			throw new UserException(
				file + " is not a CSV file in UTF-8; save it as one.", e);
		}
	}

	/** @return the text without the mark that some programs put first */
	static String withoutByteOrderMark(final String text) {
		return text.startsWith("\uFEFF") ? text.substring(1) : text;
	}
}
