package io.github.knotresolver.io;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.OptionText;
import io.github.knotresolver.options.UnitText;

import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;

/**
 * Contours that are to be measured: of a result folder, of a
 * {@code contours.csv}, or of the original tool's {@code MTdata.csv}.
 *
 * @param name what they are called
 * @param contours one entry a frame, in pixels, fixed end first; empty where a
 *          frame has none
 * @param calibration units as far as the files tell them, else pixels and
 *          frames
 * @param lengthErrorPx standard error of the length that all contours have in
 *          common, in pixels; 0 if it is not known
 */
public record ContourInput(String name, List<Optional<Polyline>> contours, Calibration calibration,
	double lengthErrorPx) {

	private static final int MOST_FRAMES = 1_000_000;

	public ContourInput {
		contours = List.copyOf(contours);
	}

	/**
	 * @param path a result folder or a CSV file
	 * @return its contours
	 * @throws UserException if there are none, or a file is not what it
	 *           should be, in one sentence
	 */
	public static ContourInput read(final Path path) {
		if (Files.isDirectory(path))
			return folder(path);
		final List<CsvRow> records = CsvFile.read(path);
		if (records.isEmpty())
			throw new UserException(
				path + " is empty; give a result folder, a contours.csv or an MTdata.csv.");
		final boolean original = OptionText.isNumber(records.get(0).number(0));
		final SortedMap<Integer, Polyline> contours = original
			? original(path, records)
			: ContoursCsv.read(path);
		return new ContourInput(stem(path), frames(path, contours, 0),
			original ? Calibration.NONE : unit(path, records), 0);
	}

	private static ContourInput folder(final Path folder) {
		final Path file = folder.resolve(ContoursCsv.FILE);
		if (!Files.isRegularFile(file))
			throw new UserException("The folder " + folder + " has no "
				+ ContoursCsv.FILE + "; give the folder that 'resolve' wrote.");
		final Path table = folder.resolve(FramesCsv.FILE);
		final int count = Files.isRegularFile(table) ? CsvFile.read(table).size() - 1 : 0;
		final String name = folder.toAbsolutePath().normalize().getFileName().toString();
		final List<Optional<Polyline>> frames = frames(file, ContoursCsv.read(file), count);
		final Calibration units = unit(file, CsvFile.read(file));
		final Path json = folder.resolve(ParametersJson.FILE);
		return Files.isRegularFile(json)
			? told(name, frames, json, units)
			: new ContourInput(name, frames, units, 0);
	}

	private static List<Optional<Polyline>> frames(final Path file,
		final SortedMap<Integer, Polyline> contours, final int count) {
		if (contours.isEmpty())
			throw new UserException(
				file + " has no contour" + (count > 0 ? " in any of " + count + " frames" : "")
					+ ", so there is nothing to measure; resolve or correct at least one frame.");
		final int n = Math.max(count, contours.lastKey());
		if (n > MOST_FRAMES)
			throw new UserException(file + " names frame " + n + ", more than the "
				+ MOST_FRAMES + " that can be measured; check the column.");
		final List<Optional<Polyline>> frames = new ArrayList<>();
		for (int frame = 1; frame <= n; frame++)
			frames.add(Optional.ofNullable(contours.get(frame)));
		return frames;
	}

	/** Rows of frame, x, y; 1-based pixels. */
	private static SortedMap<Integer, Polyline> original(final Path file,
		final List<CsvRow> records) {
		final SortedMap<Integer, List<Point>> points = new TreeMap<>();
		for (final CsvRow record : records) {
			final String place = file.getFileName() + ", line " + record.line();
			if (record.size() != 3)
				throw new UserException(
					place + ", has " + record.size() + " columns, but needs three: frame, x, y.");
			final int frame = OptionText.wholeNumber(place + ": frame",
				record.number(0), 1);
			points.computeIfAbsent(frame, f -> new ArrayList<>())
				.add(new Point(ContoursCsv.coordinate(place + ": x", record.number(1)) - 1,
					ContoursCsv.coordinate(place + ": y", record.number(2)) - 1));
		}
		final SortedMap<Integer, Polyline> contours = new TreeMap<>();
		points.forEach((frame, list) -> contours.put(frame, Polyline.of(list)));
		return contours;
	}

	/** The unit and pixel size that the columns unit, x and x_px tell. */
	private static Calibration unit(final Path file, final List<CsvRow> records) {
		final List<String> header = records.get(0).cells().stream()
			.map(h -> h.toLowerCase(Locale.ROOT)).toList();
		final int unit = header.indexOf("unit"), x = header.indexOf("x"),
			px = header.indexOf("x_px"), size = header.indexOf(ContoursCsv.PIXEL_SIZE);
		if (unit < 0 || size < 0 && (x < 0 || px < 0))
			return Calibration.NONE;
		final SortedSet<String> units = new TreeSet<>();
		final SortedSet<Double> sizes = new TreeSet<>();
		double sum = 0, sumPx = 0;
		for (final CsvRow record : records.subList(1, records.size())) {
			if (record.size() <= Math.max(unit, size))
				continue;
			units.add(UnitText.length(record.get(unit)));
			if (size >= 0) {
				sizes.add(OptionText.positive(ContoursCsv.PIXEL_SIZE, record.number(size)));
				continue;
			}
			sum += OptionText.number("x", record.number(x));
			sumPx += OptionText.number("x_px", record.number(px));
		}
		if (units.size() > 1 || sizes.size() > 1)
			throw new UserException(file + " mixes "
				+ (units.size() > 1
					? "the units " + String.join(", ", units)
					: "pixels of " + sizes.first() + " and " + sizes.last() + " " + units.first())
				+ "; give contours in one unit.");
		final double pixel = sizes.isEmpty() ? sum / sumPx : sizes.first();
		return units.isEmpty() || !(pixel > 0 && Double.isFinite(pixel))
			? Calibration.NONE
			: new Calibration(pixel, units.iterator().next(), 1, Calibration.NONE.timeUnit());
	}

	/** Contours of which {@code parameters.json} tells more. */
	private static ContourInput told(final String name, final List<Optional<Polyline>> frames,
		final Path json, final Calibration units) {
		try (Reader reader = Files.newBufferedReader(json, StandardCharsets.UTF_8)) {
			final JsonObject root = JsonParser.parseReader(reader).getAsJsonObject();
			// Results keep their options apart, measurements do not.
			final JsonObject options = root.has("options") ? root.getAsJsonObject("options") : root;
			final Optional<Double> size = number(options, "pixel_size"),
				interval = number(options, "frame_interval");
			final String time = options.has("time_unit")
				? UnitText.time(options.get("time_unit").getAsString())
				: interval.isPresent() ? UnitText.SECOND : Calibration.NONE.timeUnit();
			final Calibration c = new Calibration(size.orElse(units.pixelSize()), units.unit(),
				interval.orElse(1.0), time);
			final double error = root.has("found")
				? number(root.getAsJsonObject("found"), "length_uncertainty").orElse(0.0)
				: 0;
			return new ContourInput(name, frames, c, error / c.pixelSize());
		} catch (final IOException | JsonParseException | IllegalStateException | ClassCastException
			| IllegalArgumentException | UnsupportedOperationException e) {
			throw new UserException(
				json + " is damaged; resolve the movie again, or give its contours.csv alone.", e);
		}
	}

	private static Optional<Double> number(final JsonObject options, final String key) {
		final JsonElement value = options.get(key);
		return value == null || value.isJsonNull()
			? Optional.empty()
			: Optional.of(value.getAsDouble());
	}

	private static String stem(final Path file) {
		final String name = file.getFileName().toString();
		final int dot = name.lastIndexOf('.');
		return dot > 0 ? name.substring(0, dot) : name;
	}
}
