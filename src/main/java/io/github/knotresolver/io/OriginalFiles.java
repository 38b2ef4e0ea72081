
package io.github.knotresolver.io;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.geometry.Calibration;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.DominantFrequency;
import io.github.knotresolver.measure.Quantity;

/**
 * The original tool's files, so that its users' scripts go on working.
 * <p>
 * {@code MTdata.csv}: {@code frame,x,y} without header, 1-based pixels.
 * {@code statsSummary.txt}: lengths of the contours as they are (not smoothed),
 * tip angles in degrees from the x axis, counter-clockwise on the screen,
 * folded to -90..90 as the original does: from the last links of the contour,
 * and "smooth" from the smoothed contour.
 */
public final class OriginalFiles {

	/** The contours' file in a result folder. */
	public static final String CONTOURS = "MTdata.csv";
	/** The statistics' file in a result folder. */
	public static final String STATISTICS = "statsSummary.txt";

	/** Arc length over which the tip's direction is taken, in pixels. */
	private static final double TIP_PX = 5;
	private static final String MICRON = "micron";

	private OriginalFiles() {
	}

	/**
	 * @param file the file to write
	 * @param result a measured result
	 * @throws IOException if the disk says no
	 */
	public static void writeContours(final Path file, final MeasuredResolution result)
		throws IOException {
		try (CSVPrinter csv = CsvFile.create(file)) {
			for (final MeasuredFrame frame : result.frames()) {
				if (frame.tracked().contour().isEmpty())
					continue;
				final Polyline contour = frame.tracked().contour().get();
				for (int i = 0; i < contour.size(); i++)
					csv.printRecord(frame.tracked().frame(), NumberText.pixels(contour.x(i) + 1),
						NumberText.pixels(contour.y(i) + 1));
			}
		}
	}

	/**
	 * @param file the file to write
	 * @param result a measured result
	 * @throws IOException if the disk says no
	 */
	public static void writeStatistics(final Path file, final MeasuredResolution result)
		throws IOException {
		final Calibration c = result.calibration();
		final List<MeasuredFrame> measured = result.frames().stream()
			.filter(f -> !Double.isNaN(f.length())).toList();
		final LengthStatistics s = LengthStatistics
			.ofLengths(measured.stream().mapToDouble(f -> length(f, c)).toArray());
		final String unit = c.unit().equals("µm") ? MICRON : c.unit();
		try (BufferedWriter out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
			out.write("Statistics Summary\n------------------\n");
			out.write("Scaling Factor: " + NumberText.fixed(c.pixelSize(), 5) + "\n");
			out.write("Time Step: " + NumberText.fixed(c.frameInterval(), 2) + "\n");
			out.write("Distance ignored from end (" + unit + "s): 0.00\n");
			out.write("Dominant Frequency (" + result.frequencyUnit() + "): "
				+ number(
					result.dominantFrequency().map(DominantFrequency::frequency).orElse(Double.NaN),
					5)
				+ "\n\n");
			out.write("Mean Length, Median Length, Std Length, Min Length, Max Length\n");
			out.write(String.join(", ", number(s.mean(), 2), number(s.median(), 2),
				number(s.sd(), 2), number(s.min(), 2), number(s.max(), 2)) + "\n");
			out.write("Frame, Length (" + unit
				+ "), Tip Angle, Tip Angle (smooth), EndToEndDistance (" + unit + ")\n");
			for (final MeasuredFrame frame : measured)
				out.write(row(frame, c) + "\n");
		}
	}

	private static String row(final MeasuredFrame frame, final Calibration c) {
		final Polyline contour = frame.tracked().contour().orElseThrow();
		return frame.tracked().frame() + ", " + number(length(frame, c), 3) + ", "
			+ number(folded(tipDirection(contour)), 3) + ", "
			+ number(folded(frame.get(Quantity.TIP_ANGLE)), 3) + ", "
			+ number(frame.get(Quantity.END_TO_END), 3);
	}

	private static double length(final MeasuredFrame frame, final Calibration c) {
		return frame.tracked().contour().orElseThrow().length() * c.pixelSize();
	}

	private static double tipDirection(final Polyline contour) {
		final Point base = contour.at(contour.length() - TIP_PX);
		return Math.atan2(contour.last().y() - base.y(), contour.last().x() - base.x());
	}

	/** From radians, y down, to degrees, y up, in -90..90. */
	private static double folded(final double angle) {
		return Math.toDegrees(Math.atan(Math.tan(-angle)));
	}

	private static String number(final double value, final int decimals) {
		return Double.isFinite(value) ? NumberText.fixed(value, decimals) : "NaN";
	}
}
