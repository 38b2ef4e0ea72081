package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.OptionText;
import io.github.knotresolver.options.RunOptions;

/**
 * {@code corrections.csv}: what a person says about frames, one row a point:
 * {@code filament,frame,kind,index,x_px,y_px}. {@code kind} is {@code contour} (the
 * whole curve, fixed end first), {@code through} (passes here), {@code tip} (ends
 * here), {@code not} (not this curve; an {@code index} that begins anew is another
 * one), {@code swap} (from here on exchanged with the filament that passes the second
 * place) or {@code checked} (what was found here is right, and passes these places). A file without {@code filament} and {@code kind}, such as one with
 * {@code frame,index,x_px,y_px}, holds contours of filament 1.
 */
public final class CorrectionsCsv {

	/** The file's name in a result folder. */
	public static final String FILE = "corrections.csv";

	private static final String FILAMENT = "filament", FRAME = "frame", KIND = "kind",
		INDEX = "index", X = "x_px", Y = "y_px";
	private static final String[] HEADER = {FILAMENT, FRAME, KIND, INDEX, X, Y};

	private CorrectionsCsv() {
	}

	/**
	 * @param options the options of a run
	 * @return what the file that they name says; nothing if they name no file
	 * @throws UserException if the file cannot be read as corrections, in one sentence
	 */
	public static List<Constraint> of(final RunOptions options) {
		return options.corrections().map(CorrectionsCsv::read).orElse(List.of());
	}

	/**
	 * @param file the file
	 * @return what it says, in the order of frames
	 * @throws UserException if it is not such a file; the sentence names the line
	 */
	public static List<Constraint> read(final Path file) {
		final List<CsvFile.Row> rows = CsvFile.read(file);
		final Columns columns = Columns.of(file, rows);
		final Map<Group, SortedMap<Integer, Point>> groups = new LinkedHashMap<>();
		for (final CsvFile.Row row : rows.subList(1, rows.size()))
			columns.addTo(groups, row);
		final List<Constraint> all = new ArrayList<>();
		groups.forEach((group, points) -> all.add(new Constraint(group.filament, group.frame,
			group.kind, Polyline.of(new ArrayList<>(points.values())))));
		return Constraint.sorted(all);
	}

	/**
	 * @param file the file to write
	 * @param constraints what a person said
	 * @throws IOException if the file cannot be written
	 */
	public static void write(final Path file, final List<Constraint> constraints)
		throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, HEADER)) {
			for (final Constraint c : Constraint.sorted(constraints))
				for (int i = 0; i < c.shape().size(); i++)
					csv.printRecord(c.filament(), c.frame(), c.kind().label(), i,
						NumberText.pixels(c.shape().x(i)), NumberText.pixels(c.shape().y(i)));
		}
	}

	/**
	 * @param said what a person said
	 * @return the same as {@link #read} gives it back: with the decimals that the file has
	 */
	public static Constraint asWritten(final Constraint said) {
		return said.with(shape -> {
			final double[] x = shape.xs(), y = shape.ys();
			for (int i = 0; i < x.length; i++) {
				x[i] = Double.parseDouble(NumberText.pixels(x[i]));
				y[i] = Double.parseDouble(NumberText.pixels(y[i]));
			}
			return Polyline.of(x, y);
		});
	}

	/** The rows of one constraint; {@code part} tells several refused contours apart. */
	private record Group(int filament, int frame, Kind kind, int part) {

		Group with(final int other) {
			return new Group(filament, frame, kind, other);
		}
	}

	/** Where the columns of a file are. */
	private record Columns(String file, Map<String, Integer> places) {

		static Columns of(final Path file, final List<CsvFile.Row> rows) {
			final Map<String, Integer> places = new TreeMap<>();
			final List<String> header = rows.isEmpty() ? List.of() : rows.get(0).cells();
			for (int i = 0; i < header.size(); i++)
				places.putIfAbsent(header.get(i).toLowerCase(Locale.ROOT), i);
			if (!places.keySet().containsAll(List.of(FRAME, INDEX, X, Y)))
				throw new UserException(file
					+ " must have the columns frame,index,x_px,y_px, and filament and kind for more than contours of one filament, but its first line is '"
					+ String.join(",", header) + "'.");
			return new Columns(file.getFileName().toString(), places);
		}

		void addTo(final Map<Group, SortedMap<Integer, Point>> groups, final CsvFile.Row row) {
			final String place = file + ", line " + row.line();
			if (row.size() <= places.values().stream().mapToInt(i -> i).max().orElse(0))
				throw new UserException(
					place + ", has " + row.size() + " columns, fewer than its header.");
			final int frame = whole(row, FRAME, 1), index = whole(row, INDEX, 0);
			final int filament = places.containsKey(FILAMENT) ? whole(row, FILAMENT, 1) : 1;
			final Kind kind = places.containsKey(KIND) ? kind(row) : Kind.CONTOUR;
			final Point point = new Point(coordinate(row, X), coordinate(row, Y));
			final Group group = new Group(filament, frame, kind,
				kind == Kind.NOT ? part(groups, new Group(filament, frame, kind, 0), index) : 0);
			if (groups.computeIfAbsent(group, g -> new TreeMap<>()).put(index, point) != null)
				throw new UserException(
					place + ": frame " + frame + " has two points with index " + index + ".");
		}

		/** The last contour goes on while its indices rise. */
		private static int part(final Map<Group, SortedMap<Integer, Point>> groups,
			final Group first, final int index) {
			int part = 0;
			while (groups.containsKey(first.with(part + 1)))
				part++;
			final SortedMap<Integer, Point> last = groups.get(first.with(part));
			return last != null && index <= last.lastKey() ? part + 1 : part;
		}

		private int whole(final CsvFile.Row row, final String column, final int least) {
			return OptionText.wholeNumber(place(row, column), row.number(places.get(column)),
				least);
		}

		private double coordinate(final CsvFile.Row row, final String column) {
			return ContoursCsv.coordinate(place(row, column), row.number(places.get(column)));
		}

		private Kind kind(final CsvFile.Row row) {
			final String text = row.get(places.get(KIND));
			return Arrays.stream(Kind.values()).filter(k -> k.label().equalsIgnoreCase(text))
				.findFirst()
				.orElseThrow(() -> OptionText.refusal(place(row, KIND), Arrays.stream(Kind.values())
					.map(Kind::label).collect(Collectors.joining(" or ")), text));
		}

		private String place(final CsvFile.Row row, final String column) {
			return file + ", line " + row.line() + ": " + column;
		}
	}
}
