package io.github.knotresolver.io;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeMap;

import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.UserException;

/**
 * What a page of many results shows of one, from its tables.
 *
 * @param filaments its filaments, in the order of their numbers
 */
public record ResultDigest(List<Filament> filaments) {

	/**
	 * A filament.
	 *
	 * @param number from 1
	 * @param length its length with its standard error and unit, for people; empty if it is not known
	 * @param frames the frames in their order
	 */
	public record Filament(int number, String length, List<Frame> frames) {

		public Filament {
			frames = List.copyOf(frames);
		}
	}

	/**
	 * A filament in a frame.
	 *
	 * @param status what became of it
	 * @param confidence 0..1; 0 if it is not told
	 */
	public record Frame(FrameStatus status, double confidence) {
	}

	private static final int STATUS = 0, CONFIDENCE = 1, FILAMENT = 2;

	public ResultDigest {
		filaments = List.copyOf(filaments);
	}

	/** @return how many frames the movie has */
	public int frames() {
		return filaments.stream().mapToInt(f -> f.frames().size()).max().orElse(0);
	}

	/** @return of how many frames all filaments that are in view are known */
	public long resolved() {
		long resolved = 0;
		for (int i = 0; i < frames(); i++)
			resolved += isKnown(i) ? 1 : 0;
		return resolved;
	}

	private boolean isKnown(final int index) {
		boolean some = false;
		for (final Filament filament : filaments) {
			if (index >= filament.frames().size())
				return false;
			final FrameStatus status = filament.frames().get(index).status();
			if (status == FrameStatus.ABSENT)
				continue;
			if (status != FrameStatus.RESOLVED && status != FrameStatus.CORRECTED)
				return false;
			some = true;
		}
		return some;
	}

	/**
	 * Reads a result.
	 *
	 * @param folder its folder
	 * @return the digest; empty if its tables cannot be read
	 */
	public static Optional<ResultDigest> read(final Path folder) {
		try {
			final TreeMap<Integer, String> lengths = lengths(folder.resolve(FilamentsCsv.FILE));
			final TreeMap<Integer, List<Frame>> frames = frames(folder.resolve(FramesCsv.FILE));
			return Optional.of(new ResultDigest(frames.entrySet().stream().map(
				e -> new Filament(e.getKey(), lengths.getOrDefault(e.getKey(), ""), e.getValue()))
				.toList()));
		} catch (final UserException | IllegalArgumentException | IndexOutOfBoundsException e) {
			// The tables were changed, or removed, since they were written.
			return Optional.empty();
		}
	}

	private static TreeMap<Integer, List<Frame>> frames(final Path file) {
		final List<CsvFile.Row> rows = CsvFile.read(file);
		final int[] columns = columns(rows, "status", "confidence", ContoursCsv.FILAMENT);
		final TreeMap<Integer, List<Frame>> frames = new TreeMap<>();
		for (final CsvFile.Row row : rows.subList(1, rows.size())) {
			final String confidence = row.number(columns[CONFIDENCE]);
			frames
				.computeIfAbsent(Integer.valueOf(row.number(columns[FILAMENT])),
					k -> new ArrayList<>())
				.add(new Frame(
					FrameStatus.valueOf(row.get(columns[STATUS]).toUpperCase(Locale.ROOT)),
					confidence.isEmpty() ? 0 : Double.parseDouble(confidence)));
		}
		return frames;
	}

	private static TreeMap<Integer, String> lengths(final Path file) {
		final List<CsvFile.Row> rows = CsvFile.read(file);
		final int[] columns = columns(rows, "length", "length_se", ContoursCsv.FILAMENT, "unit");
		final TreeMap<Integer, String> lengths = new TreeMap<>();
		for (final CsvFile.Row row : rows.subList(1, rows.size())) {
			final String length = row.number(columns[0]), error = row.number(columns[1]);
			lengths.put(Integer.valueOf(row.number(columns[2])),
				length.isEmpty()
					? ""
					: rounded(length) + (error.isEmpty() ? "" : " ± " + rounded(error)) + " "
						+ row.get(columns[3]));
		}
		return lengths;
	}

	private static String rounded(final String number) {
		return String.format(Locale.ROOT, "%.2f", Double.parseDouble(number));
	}

	private static int[] columns(final List<CsvFile.Row> rows, final String... names) {
		final int[] columns = new int[names.length];
		for (int i = 0; i < names.length; i++) {
			columns[i] = rows.isEmpty() ? -1 : rows.get(0).cells().indexOf(names[i]);
			if (columns[i] < 0)
				throw new IllegalArgumentException("There is no column " + names[i] + ".");
		}
		return columns;
	}
}
