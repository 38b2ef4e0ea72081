
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.measure.MeasuredFrame;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.options.OptionText;

/**
 * {@code frames.csv}: one row for every frame of the movie. {@code length} and
 * {@code end_to_end} are in the row's {@code unit}, {@code tip_angle} in
 * radians; what is not known is empty.
 */
public final class FramesCsv {

	/** The file's name in a result folder. */
	public static final String FILE = "frames.csv";

	private static final String[] HEADER = {"frame", "status", "reason", "length", "end_to_end",
		"tip_angle", "junctions", "crossings", "candidates", "cost", "confidence", "unit",
		ContoursCsv.FILAMENT, "visible", "checked"};

	private FramesCsv() {
	}

	/**
	 * @param file the file to write
	 * @param result a measured result
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final MeasuredTracks result) throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, HEADER)) {
			for (final MeasuredFrame frame : result.frames()) {
				final Observation tracked = frame.tracked();
				csv.printRecord(tracked.frame(), tracked.status().label(), tracked.reason(),
					text(frame, Quantity.LENGTH), text(frame, Quantity.END_TO_END),
					text(frame, Quantity.TIP_ANGLE), tracked.junctions(), tracked.crossings(),
					tracked.candidates(), NumberText.significant(tracked.cost()),
					NumberText.significant(tracked.confidence()), result.calibration().unit(),
					frame.filament(), visible(tracked),
					result.tracks().isChecked(frame.filament(), tracked) ? 1 : 0);
			}
		}
	}

	/**
	 * @param file a file of frames, present or not
	 * @return the number of the last frame in it; 0 if there is none
	 */
	static int lastFrame(final Path file) {
		if (!Files.isRegularFile(file))
			return 0;
		final List<CsvFile.Row> rows = CsvFile.read(file);
		final int column = rows.isEmpty() ? -1 : column(rows.get(0), "frame");
		// Anything but a number is not a row of ours; the contours then say how many there are.
		return column < 0
			? Math.max(0, rows.size() - 1)
			: rows.stream().skip(1).filter(r -> r.size() > column).map(r -> r.number(column))
				.filter(t -> t.matches("[0-9]{1,7}")).mapToInt(Integer::parseInt).max().orElse(0);
	}

	/**
	 * How sure a result is of its contours.
	 *
	 * @param file a file of frames, present or not
	 * @return the confidence by the filament's number and the frame; none if there is no
	 *         such file, or it does not tell
	 */
	public static Map<Integer, Map<Integer, Double>> confidences(final Path file) {
		final Map<Integer, Map<Integer, Double>> all = new TreeMap<>();
		if (!Files.isRegularFile(file))
			return all;
		final List<CsvFile.Row> rows = CsvFile.read(file);
		if (rows.isEmpty())
			return all;
		final int frame = column(rows.get(0), "frame"),
			confidence = column(rows.get(0), "confidence"),
			filament = column(rows.get(0), ContoursCsv.FILAMENT);
		if (frame < 0 || confidence < 0)
			return all;
		for (final CsvFile.Row row : rows.subList(1, rows.size())) {
			if (row.size() <= Math.max(frame, confidence) || row.get(confidence).isEmpty())
				continue;
			final String place = file.getFileName() + ", line " + row.line() + ": ";
			final int number = filament < 0 || row.size() <= filament
				? 1
				: OptionText.wholeNumber(place + ContoursCsv.FILAMENT, row.number(filament), 1);
			all.computeIfAbsent(number, k -> new TreeMap<>()).put(
				OptionText.wholeNumber(place + "frame", row.number(frame), 1),
				OptionText.number(place + "confidence", row.number(confidence)));
		}
		return all;
	}

	private static int column(final CsvFile.Row header, final String name) {
		return header.cells().stream().map(h -> h.toLowerCase(Locale.ROOT)).toList().indexOf(name);
	}

	/** Of a filament that was not found, nobody knows it. */
	private static String visible(final Observation tracked) {
		return switch (tracked.status()) {
			case RESOLVED, CORRECTED -> NumberText.significant(tracked.visible());
			case ABSENT -> "0";
			case UNRESOLVED, LOST, IGNORED -> "";
		};
	}

	private static String text(final MeasuredFrame frame, final Quantity quantity) {
		return NumberText.significant(frame.get(quantity));
	}
}
