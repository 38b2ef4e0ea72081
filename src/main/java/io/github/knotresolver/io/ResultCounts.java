package io.github.knotresolver.io;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.UserException;

/**
 * A finished result in a few numbers. A frame counts once for each filament.
 *
 * @param resolved frames with a contour that is sure, or that a person has checked
 * @param doubtful frames with a contour of a confidence below {@link Observation#SURE} that nobody has checked
 * @param lost frames that ought to have a contour, and have none
 * @param filaments how many filaments there are
 * @param length the first filament's length with its unit; empty if it is not known
 */
public record ResultCounts(int resolved, int doubtful, int lost, int filaments, String length) {

	/**
	 * @param folder a result folder
	 * @return its numbers; empty if its tables are missing, or those of another version
	 */
	public static Optional<ResultCounts> read(final Path folder) {
		try {
			return Optional.of(of(NamedTable.read(folder.resolve(FramesCsv.FILE)),
				NamedTable.read(folder.resolve(FilamentsCsv.FILE))));
		} catch (final UserException | IllegalArgumentException e) {
			return Optional.empty();
		}
	}

	private static ResultCounts of(final NamedTable frames, final NamedTable filaments) {
		int resolved = 0, doubtful = 0, lost = 0;
		for (final CsvFile.Row row : frames.rows()) {
			final boolean checked = frames.text(row, "checked").equals("1");
			switch (frames.text(row, "status")) {
				case "resolved", "corrected" -> {
					if (checked || frames.number(row, "confidence") >= Observation.SURE)
						resolved++;
					else
						doubtful++;
				}
				case "unresolved", "lost" -> lost++;
				default -> {
					// Not in view, or left out as asked.
				}
			}
		}
		return new ResultCounts(resolved, doubtful, lost, filaments.rows().size(),
			filaments.rows().isEmpty() ? "" : length(filaments, filaments.rows().get(0)));
	}

	private static String length(final NamedTable filaments, final CsvFile.Row row) {
		final double length = filaments.number(row, "length");
		return Double.isNaN(length)
			? ""
			: String.format(Locale.ROOT, "%.2f %s", length, filaments.text(row, "unit"));
	}
}
