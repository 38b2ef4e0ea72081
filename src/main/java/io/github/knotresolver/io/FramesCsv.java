
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Path;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

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
	 * @throws IOException if the disk says no
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
					frame.filament(), visible(tracked), checked(tracked));
			}
		}
	}

	/** Of a filament that was not found, nobody knows it. */
	private static String visible(final Observation tracked) {
		return switch (tracked.status()) {
			case RESOLVED, CORRECTED -> NumberText.significant(tracked.visible());
			case ABSENT -> "0";
			case UNRESOLVED, LOST, IGNORED -> "";
		};
	}

	private static int checked(final Observation tracked) {
		return tracked.status() == FrameStatus.CORRECTED ? 1 : 0;
	}

	private static String text(final MeasuredFrame frame, final Quantity quantity) {
		return NumberText.significant(frame.get(quantity));
	}
}
