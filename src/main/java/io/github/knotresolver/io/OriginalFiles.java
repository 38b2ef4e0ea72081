
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.DominantFrequency;
import io.github.knotresolver.measure.LengthStatistics;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.measure.MeasuredFrame;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.measure.OriginalQuantities;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.model.Calibration;

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

	private OriginalFiles() {
	}

	/**
	 * @param file the file to write
	 * @param filament a measured filament
	 * @throws IOException if a file cannot be written
	 */
	public static void writeContours(final Path file, final MeasuredFilament filament)
		throws IOException {
		try (CSVPrinter csv = CsvFile.create(file)) {
			for (final MeasuredFrame frame : filament.frames()) {
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
	 * @param filament a measured filament
	 * @param result the result that it belongs to
	 * @throws IOException if a file cannot be written
	 */
	public static void writeStatistics(final Path file, final MeasuredFilament filament,
		final MeasuredTracks result) throws IOException {
		final Calibration c = result.calibration();
		final List<MeasuredFrame> measured = filament.frames().stream()
			.filter(f -> !Double.isNaN(f.length())).toList();
		writeStatistics(file,
			new OriginalQuantities(measured.stream().mapToInt(f -> f.tracked().frame()).toArray(),
				values(measured, f -> length(f, c)),
				values(measured, f -> folded(tipDirection(f.tracked().contour().orElseThrow()))),
				values(measured, f -> folded(f.get(Quantity.TIP_ANGLE))),
				values(measured, f -> f.get(Quantity.END_TO_END)),
				filament.dominantFrequency().map(DominantFrequency::frequency).orElse(Double.NaN)),
			c, result.calibration().frequencyUnit());
	}

	/**
	 * @param file the file to write
	 * @param original the quantities
	 * @param c units
	 * @param frequencyUnit unit of the dominant frequency
	 * @throws IOException if a file cannot be written
	 */
	public static void writeStatistics(final Path file, final OriginalQuantities original,
		final Calibration c, final String frequencyUnit) throws IOException {
		final LengthStatistics s = LengthStatistics.ofLengths(original.length());
		final String unit = c.unit().equals("µm") ? "micron" : c.unit();
		final List<String> lines = new ArrayList<>(List.of("Statistics Summary",
			"------------------", "Scaling Factor: " + text(c.pixelSize(), 5),
			"Time Step: " + text(c.frameInterval(), 2),
			"Distance ignored from end (" + unit + "s): 0.00",
			"Dominant Frequency (" + frequencyUnit + "): " + text(original.dominantFrequency(), 5),
			"", "Mean Length, Median Length, Std Length, Min Length, Max Length",
			String.join(", ", text(s.mean(), 2), text(s.median(), 2), text(s.sd(), 2),
				text(s.min(), 2), text(s.max(), 2)),
			"Frame, Length (" + unit + "), Tip Angle, Tip Angle (smooth), EndToEndDistance (" + unit
				+ ")"));
		for (int i = 0; i < original.frame().length; i++)
			lines.add(String.join(", ", String.valueOf(original.frame()[i]),
				text(original.length()[i], 3), text(original.tipAngle()[i], 3),
				text(original.smoothTipAngle()[i], 3), text(original.endToEnd()[i], 3)));
		Files.writeString(file, String.join("\n", lines) + "\n", StandardCharsets.UTF_8);
	}

	private static double[] values(final List<MeasuredFrame> frames,
		final ToDoubleFunction<MeasuredFrame> value) {
		return frames.stream().mapToDouble(value).toArray();
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

	private static String text(final double value, final int decimals) {
		return Double.isFinite(value) ? NumberText.fixed(value, decimals) : "NaN";
	}
}
