package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.model.UserException;

/**
 * The row of one movie in a batch sheet, in the original tool's columns. All other rows, and columns
 * that mean nothing here, stay as they are.
 */
public final class SheetRow {

	private static final String FILE_NAME = "FileName", FOLDER = "FolderPath", NONE = "False";

	/** The original tool's columns with what they hold if nothing is said. */
	private static final Map<String, String> COLUMNS = new LinkedHashMap<>();

	static {
		COLUMNS.put(FILE_NAME, "");
		COLUMNS.put(FOLDER, "");
		COLUMNS.put("segThresh", "0");
		COLUMNS.put("segIteration", "");
		COLUMNS.put("segContract", "");
		COLUMNS.put("segSmooth", "");
		COLUMNS.put("requiresManual", NONE);
		COLUMNS.put("IgnoreFrames", "0");
		COLUMNS.put("useLogP", NONE);
		COLUMNS.put("logPk", "0");
		COLUMNS.put("logPs", "0");
		COLUMNS.put("InvertManual", NONE);
		COLUMNS.put("manualCheck", NONE);
	}

	private final Path sheet, movie;

	/**
	 * @param sheet a CSV file, there or not
	 * @param movie the movie's file
	 */
	public SheetRow(final Path sheet, final Path movie) {
		this.sheet = sheet.toAbsolutePath().normalize();
		this.movie = movie.toAbsolutePath().normalize();
	}

	/**
	 * @return whether the sheet has a row for the movie
	 * @throws UserException if the file is no sheet, in one sentence
	 */
	public boolean isThere() {
		return Files.exists(sheet) && place() >= 0;
	}

	/** The index of the movie's row among those below the header; -1 if there is none. */
	private int place() {
		final List<BatchRow> rows = BatchSheet.read(sheet).rows();
		for (int i = 0; i < rows.size(); i++)
			if (Path.of(rows.get(i).movie()).toAbsolutePath().normalize().equals(movie))
				return i;
		return -1;
	}

	/**
	 * Writes the row: into a new sheet, below the others, or in place of the row of the same movie. The
	 * sheet is complete or as it was.
	 *
	 * @param texts options of the segmentation by key; {@code otsu} and nothing are automatic
	 * @param replace whether a row of the same movie may be replaced
	 * @throws UserException if it may not, or the file is no sheet that can be written, in one sentence
	 * @throws IOException if the file cannot be written
	 */
	public void write(final Map<String, String> texts, final boolean replace) throws IOException {
		final List<List<String>> table = table();
		final List<String> header = table.get(0);
		for (final String column : COLUMNS.keySet())
			if (index(header, column) < 0) {
				header.add(column);
				table.subList(1, table.size()).forEach(row -> row.add(""));
			}
		final int place = Files.exists(sheet) ? place() : -1;
		if (place >= 0 && !replace)
			throw new UserException(sheet + " has a row for " + movie.getFileName()
				+ " already; say that it may be replaced.");
		if (place < 0)
			table.add(fresh(header));
		final List<String> row = table.get(place < 0 ? table.size() - 1 : place + 1);
		values(texts).forEach((column, value) -> row.set(index(header, column), value));
		write(table);
	}

	private List<List<String>> table() throws IOException {
		final List<List<String>> table = new ArrayList<>();
		if (!Files.exists(sheet)) {
			table.add(new ArrayList<>(COLUMNS.keySet()));
			return table;
		}
		BatchSheet.read(sheet);
		final String first = Files.readString(sheet, StandardCharsets.ISO_8859_1).lines()
			.findFirst().orElse("");
		if (first.matches(".*[;\\t].*"))
			throw new UserException(sheet
				+ " is not separated by commas, and is only read; save it as comma-separated CSV to have a row written.");
		for (final CsvFile.Row row : CsvFile.read(sheet))
			table.add(new ArrayList<>(row.cells()));
		final int width = table.get(0).size();
		for (final List<String> row : table)
			while (row.size() < width)
				row.add("");
		return table;
	}

	private static int index(final List<String> header, final String column) {
		for (int i = 0; i < header.size(); i++)
			if (header.get(i).toLowerCase(Locale.ROOT).equals(column.toLowerCase(Locale.ROOT)))
				return i;
		return -1;
	}

	private List<String> fresh(final List<String> header) {
		final List<String> row = new ArrayList<>();
		for (int i = 0; i < header.size(); i++)
			row.add("");
		COLUMNS.forEach((column, value) -> row.set(index(header, column), value));
		final Path home = sheet.getParent(), folder = movie.getParent();
		row.set(index(header, FILE_NAME), movie.getFileName().toString());
		row.set(index(header, FOLDER),
			(folder.startsWith(home) ? home.relativize(folder) : folder).toString());
		return row;
	}

	private static Map<String, String> values(final Map<String, String> texts) {
		final Map<String, String> values = new LinkedHashMap<>();
		final String threshold = texts.getOrDefault("threshold", ""),
			size = texts.getOrDefault("log_size", "");
		values.put("segThresh", threshold.matches("[0-9.]+") ? threshold : "0");
		values.put("segIteration", texts.getOrDefault("iterations", ""));
		values.put("segContract", texts.getOrDefault("contraction_bias", ""));
		values.put("segSmooth", texts.getOrDefault("smooth_factor", ""));
		final boolean enhances = !size.isEmpty() && !size.equals("0");
		values.put("useLogP", enhances ? "True" : NONE);
		values.put("logPk", enhances ? size : "0");
		values.put("logPs", enhances ? texts.getOrDefault("log_sigma", "0") : "0");
		return values;
	}

	private void write(final List<List<String>> table) throws IOException {
		final Path partial = Files.createTempFile(sheet.getParent(), ".sheet", ".part");
		try {
			try (CSVPrinter printer = CsvFile.create(partial)) {
				printer.printRecords(table);
			}
			Files.move(partial, sheet, StandardCopyOption.REPLACE_EXISTING);
		} finally {
			Files.deleteIfExists(partial);
		}
	}
}
