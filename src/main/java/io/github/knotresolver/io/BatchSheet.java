package io.github.knotresolver.io;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;

/**
 * A sheet of movies with their options, one row a movie: the original tool's
 * sheet as it is, and columns named as the options of {@link RunOptions}. Names
 * of columns are read in any case.
 *
 * @param rows the rows, in order
 * @param unknownColumns columns that mean nothing to this program
 */
public record BatchSheet(List<BatchRow> rows, List<String> unknownColumns) {

	private static final String FILE_NAME = "filename", FOLDER = "folderpath";
	/** Columns in which a comma is not that of a number. */
	private static final Set<String> COMMAS = Set.of(FILE_NAME, FOLDER, "fixed_end", "region",
		"frames", "ignore_frames", "ignoreframes", "corrections", "unit");

	public BatchSheet {
		rows = List.copyOf(rows);
		unknownColumns = List.copyOf(unknownColumns);
	}

	/**
	 * Reads a sheet. Values are checked later, row by row, so one bad row does not
	 * stop the others.
	 *
	 * @param file the sheet; relative folders in it are relative to it
	 * @return its rows
	 * @throws UserException if it is not a sheet, in one sentence
	 */
	public static BatchSheet read(final Path file) {
		final List<CsvFile.Row> records = CsvFile.read(file);
		final List<String> header = records.isEmpty() ? List.of() : records.get(0).cells();
		final List<String> keys = header.stream().map(h -> h.toLowerCase(Locale.ROOT)).toList();
		if (!keys.contains(FILE_NAME) || !keys.contains(FOLDER))
			throw new UserException(
				file + " must have the columns FileName and FolderPath, but its first line is '"
					+ String.join(",", header) + "'.");
		final Path home = file.toAbsolutePath().getParent();
		final List<BatchRow> rows = new ArrayList<>();
		for (final CsvFile.Row record : records.subList(1, records.size()))
			rows.add(row(home, keys, record));
		return new BatchSheet(rows,
			header.stream().filter(h -> !isKnown(h.toLowerCase(Locale.ROOT))).toList());
	}

	private static boolean isKnown(final String key) {
		return key.equals(FILE_NAME) || key.equals(FOLDER) || RunOptions.KEYS.contains(key)
			|| OriginalColumns.NAMES.contains(key);
	}

	private static BatchRow row(final Path home, final List<String> keys,
		final CsvFile.Row record) {
		final Map<String, String> cells = new HashMap<>();
		for (int i = 0; i < Math.min(keys.size(), record.size()); i++)
			cells.put(keys.get(i), COMMAS.contains(keys.get(i)) ? record.get(i) : record.number(i));
		final List<String> notes = new ArrayList<>();
		final Map<String, String> texts = OriginalColumns.translate(cells, notes);
		for (final String key : RunOptions.KEYS)
			if (cells.containsKey(key) && !cells.get(key).isBlank())
				texts.put(key, cells.get(key));
		texts.computeIfPresent("corrections", (key, path) -> resolved(home, path));
		final String movie = resolved(home, cells.getOrDefault(FOLDER, ""),
			cells.getOrDefault(FILE_NAME, ""));
		return new BatchRow(record.line(), movie, texts, OriginalColumns.isByHand(cells), notes);
	}

	/** A name that no file can have here spoils its row, when that has its turn, not the sheet. */
	private static String resolved(final Path home, final String... parts) {
		try {
			Path path = home;
			for (final String part : parts)
				path = path.resolve(part);
			return path.normalize().toString();
		} catch (final InvalidPathException e) {
			return String.join("/", parts);
		}
	}
}
