
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.MeasuredFrame;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.OptionText;
import io.github.knotresolver.progress.Cancellation;

/**
 * {@code contours.csv}: one row a point. {@code x_px, y_px} is the contour as it was
 * found, in pixels (origin top-left, an integer is a pixel centre). {@code x, y} is
 * the smoothed contour, and {@code arc_length, tangent_angle, curvature} are those of
 * this curve: lengths in the row's {@code unit}, {@code tangent_angle} in radians,
 * {@code curvature} in 1/unit. {@code pixel_size} is a pixel's edge in the unit.
 * {@code filament} is the filament's number, from 1. Corrections by a user have the
 * first four columns.
 */
public final class ContoursCsv {

	/** The file's name in a result folder. */
	public static final String FILE = "contours.csv";

	/** The column that tells the filament's number; a file without it is of filament 1. */
	static final String FILAMENT = "filament";

	/** The column that tells a pixel's edge in the row's unit. */
	static final String PIXEL_SIZE = "pixel_size";

	private static final double LARGEST = 100_000;
	private static final String[] HEADER = {"frame", "index", "x_px", "y_px", "x", "y",
		"arc_length", "tangent_angle", "curvature", "unit", PIXEL_SIZE, FILAMENT};
	private static final List<String> NEEDED = List.of("frame", "index", "x_px", "y_px");

	private ContoursCsv() {
	}

	/**
	 * @param file the file to write
	 * @param result a measured result
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final MeasuredTracks result) throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, HEADER)) {
			for (final MeasuredFrame frame : result.frames())
				if (frame.tracked().contour().isPresent())
					writeContour(csv, frame, result.calibration());
		}
	}

	private static void writeContour(final CSVPrinter csv, final MeasuredFrame frame,
		final Calibration c) throws IOException {
		final Polyline contour = frame.tracked().contour().orElseThrow();
		final double[] x = frame.x(c.pixelSize()), y = frame.y(c.pixelSize()),
			arc = frame.arcLength(), angle = frame.tangentAngle(), curvature = frame.curvature();
		for (int i = 0; i < contour.size(); i++)
			csv.printRecord(frame.tracked().frame(), i, NumberText.pixels(contour.x(i)),
				NumberText.pixels(contour.y(i)), NumberText.significant(x[i]),
				NumberText.significant(y[i]), at(arc, i), at(angle, i), at(curvature, i), c.unit(),
				NumberText.significant(c.pixelSize(), 12), frame.filament());
	}

	private static String at(final double[] values, final int i) {
		return i < values.length ? NumberText.significant(values[i]) : "";
	}

	/**
	 * Reads contours of one filament: this program's own file, or one with the columns
	 * {@code frame,index,x_px,y_px} that a user made.
	 *
	 * @param file the file
	 * @return the contours in pixels, by 1-based frame
	 * @throws UserException if it is not such a file, or has several filaments; the
	 *           sentence names the line
	 */
	public static SortedMap<Integer, Polyline> read(final Path file) {
		final SortedMap<Integer, SortedMap<Integer, Polyline>> filaments = readFilaments(file);
		if (filaments.size() > 1)
			throw new UserException(file + " has contours of " + filaments.size()
				+ " filaments, but those of one are needed here; keep the rows of one.");
		return filaments.isEmpty() ? new TreeMap<>() : filaments.get(filaments.firstKey());
	}

	/**
	 * Reads contours of any number of filaments. A file without the column
	 * {@code filament} is of filament 1.
	 *
	 * @param file the file
	 * @return the contours in pixels, by the filament's number and the 1-based frame
	 * @throws UserException if it is not such a file; the sentence names the line
	 */
	public static SortedMap<Integer, SortedMap<Integer, Polyline>> readFilaments(final Path file) {
		final List<CsvFile.Row> records = CsvFile.read(file);
		final int[] columns = columns(file, records);
		final int filament = records.get(0).cells().stream().map(h -> h.toLowerCase(Locale.ROOT))
			.toList().indexOf(FILAMENT);
		final SortedMap<Integer, SortedMap<Integer, SortedMap<Integer, Point>>> points = new TreeMap<>();
		for (final CsvFile.Row record : records.subList(1, records.size())) {
			Cancellation.check();
			addPoint(file, record, columns,
				points.computeIfAbsent(filament(file, record, filament), k -> new TreeMap<>()));
		}
		final SortedMap<Integer, SortedMap<Integer, Polyline>> contours = new TreeMap<>();
		points.forEach((number, frames) -> {
			final SortedMap<Integer, Polyline> own = new TreeMap<>();
			frames.forEach(
				(frame, line) -> own.put(frame, Polyline.of(new ArrayList<>(line.values()))));
			contours.put(number, own);
		});
		return contours;
	}

	private static int filament(final Path file, final CsvFile.Row record, final int column) {
		return column < 0 || record.size() <= column || record.get(column).isEmpty()
			? 1
			: OptionText.wholeNumber(
				file.getFileName() + ", line " + record.line() + ": " + FILAMENT,
				record.number(column), 1);
	}

	/** A place in a picture; what is larger was mistyped, and would be measured for hours. */
	static double coordinate(final String place, final String text) {
		final double value = OptionText.number(place, text);
		if (Math.abs(value) > LARGEST)
			throw OptionText.refusal(place,
				"from -" + (int) LARGEST + " to " + (int) LARGEST + " pixels", text);
		return value;
	}

	private static int[] columns(final Path file, final List<CsvFile.Row> records) {
		final List<String> header = records.isEmpty()
			? List.of()
			: records.get(0).cells().stream().map(h -> h.toLowerCase(Locale.ROOT)).toList();
		if (!header.containsAll(NEEDED))
			throw new UserException(
				file + " must have the columns frame,index,x_px,y_px, but its first line is '"
					+ String.join(",", header) + "'.");
		return NEEDED.stream().mapToInt(header::indexOf).toArray();
	}

	private static void addPoint(final Path file, final CsvFile.Row record, final int[] columns,
		final SortedMap<Integer, SortedMap<Integer, Point>> frames) {
		final String place = file.getFileName() + ", line " + record.line();
		if (record.size() <= Arrays.stream(columns).max().orElse(0))
			throw new UserException(
				place + ", has " + record.size() + " columns, fewer than its header.");
		final int frame = OptionText.wholeNumber(place + ": frame", record.number(columns[0]), 1);
		final int index = OptionText.wholeNumber(place + ": index", record.number(columns[1]), 0);
		final Point point = new Point(coordinate(place + ": x_px", record.number(columns[2])),
			coordinate(place + ": y_px", record.number(columns[3])));
		if (frames.computeIfAbsent(frame, f -> new TreeMap<>(Comparator.naturalOrder())).put(index,
			point) != null)
			throw new UserException(
				place + ": frame " + frame + " has two points with index " + index + ".");
	}
}
