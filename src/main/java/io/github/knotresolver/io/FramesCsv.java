
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.geometry.Calibration;
import io.github.knotresolver.track.TrackedFrame;

/**
 * {@code frames.csv}: one row for every frame of the movie. {@code length} and
 * {@code end_to_end} are in the row's {@code unit}, {@code tip_angle} in
 * radians; what is not known is empty.
 */
public final class FramesCsv {

	/** The file's name in a result folder. */
	public static final String FILE = "frames.csv";

	private static final String[] HEADER = {"frame", "status", "reason", "length", "end_to_end",
		"tip_angle", "junctions", "crossings", "candidates", "cost", "confidence", "unit"};

	private FramesCsv() {
	}

	/**
	 * @param file the file to write
	 * @param frames the frames, measured
	 * @param calibration units
	 * @throws IOException if the disk says no
	 */
	public static void write(final Path file, final List<MeasuredFrame> frames,
		final Calibration calibration) throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, HEADER)) {
			for (final MeasuredFrame frame : frames) {
				final TrackedFrame tracked = frame.tracked();
				csv.printRecord(tracked.frame(), tracked.status().label(), tracked.reason(),
					NumberText.significant(frame.length()),
					NumberText.significant(frame.endToEnd()),
					NumberText.significant(frame.tipAngle()), tracked.junctions(),
					tracked.crossings(), tracked.candidates(),
					NumberText.significant(tracked.cost()),
					NumberText.significant(tracked.confidence()), calibration.unit());
			}
		}
	}
}
