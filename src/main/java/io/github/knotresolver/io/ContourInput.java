package io.github.knotresolver.io;

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

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.OptionText;
import io.github.knotresolver.options.UnitText;

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
 * @param filament number of the filament
 */
public record ContourInput(String name, List<Optional<Polyline>> contours, Calibration calibration,
	double lengthErrorPx, int filament) {

	private static final int MOST_FRAMES = 1_000_000;

	public ContourInput {
		contours = List.copyOf(contours);
	}

	/**
	 * Contours of the only filament.
	 *
	 * @param name what they are called
	 * @param contours one a frame, empty where there is none
	 * @param calibration units
	 * @param lengthErrorPx error of the length in pixels
	 */
	public ContourInput(final String name, final List<Optional<Polyline>> contours,
		final Calibration calibration, final double lengthErrorPx) {
		this(name, contours, calibration, lengthErrorPx, 1);
	}

	/**
	 * @param path a result folder or a CSV file of one filament
	 * @return its contours
	 * @throws UserException if there are none, a file is not what it should be, or there
	 *           are several filaments, in one sentence
	 */
	public static ContourInput read(final Path path) {
		final List<ContourInput> all = readAll(path);
		if (all.size() > 1)
			throw new UserException(path + " has " + all.size()
				+ " filaments, but one is needed here; resolve the movie with fixed_end or region.");
		return all.get(0);
	}

	/**
	 * @param path a result folder or a CSV file
	 * @return the contours of every filament, at least one, rising by their numbers
	 * @throws UserException if there are none, or a file is not what it
	 *           should be, in one sentence
	 */
	public static List<ContourInput> readAll(final Path path) {
		if (Files.isDirectory(path))
			return folder(path);
		final List<CsvFile.Row> records = CsvFile.read(path);
		if (records.isEmpty())
			throw new UserException(
				path + " is empty; give a result folder, a contours.csv or an MTdata.csv.");
		if (OptionText.isNumber(records.get(0).number(0)))
			return List.of(new ContourInput(stem(path), frames(path, original(path, records), 0),
				Calibration.NONE, 0));
		final List<ContourInput> all = all(stem(path), ContoursCsv.readFilaments(path), path, 0);
		final Calibration units = unit(path, records);
		return all.stream().map(c -> c.with(units, 0)).toList();
	}

	private static List<ContourInput> folder(final Path folder) {
		final Path file = folder.resolve(ContoursCsv.FILE);
		if (!Files.isRegularFile(file))
			throw new UserException("The folder " + folder + " has no " + ContoursCsv.FILE
				+ "; give the folder that 'resolve' wrote.");
		final String name = folder.toAbsolutePath().normalize().getFileName().toString();
		final List<ContourInput> all = all(name, ContoursCsv.readFilaments(file), file,
			FramesCsv.lastFrame(folder.resolve(FramesCsv.FILE)));
		final Calibration units = unit(file, CsvFile.read(file));
		final Path json = folder.resolve(ParametersJson.FILE);
		return Files.isRegularFile(json)
			? told(all, json, units)
			: all.stream().map(c -> c.with(units, 0)).toList();
	}

	/** All filaments, without units; those of several have their number in their name. */
	private static List<ContourInput> all(final String name,
		final SortedMap<Integer, SortedMap<Integer, Polyline>> filaments, final Path file,
		final int count) {
		if (filaments.size() < 2)
			return List.of(new ContourInput(name, frames(file,
				filaments.isEmpty() ? new TreeMap<>() : filaments.get(filaments.firstKey()), count),
				Calibration.NONE, 0, filaments.isEmpty() ? 1 : filaments.firstKey()));
		final List<ContourInput> all = new ArrayList<>();
		filaments.forEach((number, contours) -> all
			.add(new ContourInput(name + "-" + MeasuredFilament.number(number),
				frames(file, contours, count), Calibration.NONE, 0, number)));
		return all;
	}

	private ContourInput with(final Calibration units, final double errorPx) {
		return new ContourInput(name, contours, units, errorPx, filament);
	}

	private static List<Optional<Polyline>> frames(final Path file,
		final SortedMap<Integer, Polyline> contours, final int count) {
		if (contours.isEmpty())
			throw new UserException(
				file + " has no contour" + (count > 0 ? " in any of " + count + " frames" : "")
					+ ", so there is nothing to measure; resolve or correct at least one frame.");
		final int n = Math.max(count, contours.lastKey());
		if (n > MOST_FRAMES)
			throw new UserException(file + " names frame " + n + ", more than the " + MOST_FRAMES
				+ " that can be measured; check the column.");
		final List<Optional<Polyline>> frames = new ArrayList<>();
		for (int frame = 1; frame <= n; frame++)
			frames.add(Optional.ofNullable(contours.get(frame)));
		return frames;
	}

	/** Rows of frame, x, y; 1-based pixels. */
	private static SortedMap<Integer, Polyline> original(final Path file,
		final List<CsvFile.Row> records) {
		final SortedMap<Integer, List<Point>> points = new TreeMap<>();
		for (final CsvFile.Row record : records) {
			final String place = file.getFileName() + ", line " + record.line();
			if (record.size() != 3)
				throw new UserException(
					place + ", has " + record.size() + " columns, but needs three: frame, x, y.");
			final int frame = OptionText.wholeNumber(place + ": frame", record.number(0), 1);
			points.computeIfAbsent(frame, f -> new ArrayList<>())
				.add(new Point(ContoursCsv.coordinate(place + ": x", record.number(1)) - 1,
					ContoursCsv.coordinate(place + ": y", record.number(2)) - 1));
		}
		final SortedMap<Integer, Polyline> contours = new TreeMap<>();
		points.forEach((frame, list) -> contours.put(frame, Polyline.of(list)));
		return contours;
	}

	/** The unit and pixel size that the columns unit, x and x_px tell. */
	private static Calibration unit(final Path file, final List<CsvFile.Row> records) {
		final List<String> header = records.get(0).cells().stream()
			.map(h -> h.toLowerCase(Locale.ROOT)).toList();
		final int unit = header.indexOf("unit"), x = header.indexOf("x"),
			px = header.indexOf("x_px"), size = header.indexOf(ContoursCsv.PIXEL_SIZE);
		if (unit < 0 || size < 0 && (x < 0 || px < 0))
			return Calibration.NONE;
		final SortedSet<String> units = new TreeSet<>();
		final SortedSet<Double> sizes = new TreeSet<>();
		double sum = 0, sumPx = 0;
		for (final CsvFile.Row record : records.subList(1, records.size())) {
			if (record.size() <= Math.max(Math.max(unit, size), size < 0 ? Math.max(x, px) : 0))
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
	private static List<ContourInput> told(final List<ContourInput> filaments, final Path json,
		final Calibration units) {
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
			return filaments.stream()
				.map(f -> f.with(c, lengthError(root, f.filament) / c.pixelSize())).toList();
		} catch (final IOException | JsonParseException | IllegalStateException | ClassCastException
			| IllegalArgumentException | UnsupportedOperationException e) {
			throw new UserException(
				json + " is damaged; resolve the movie again, or give its contours.csv alone.", e);
		}
	}

	/** Of the filament or, in a file that has none, of the movie; 0 if it is not told. */
	private static double lengthError(final JsonObject root, final int filament) {
		if (!root.has("found"))
			return 0;
		final JsonObject found = root.getAsJsonObject("found");
		if (found.has("filaments"))
			for (final JsonElement one : found.getAsJsonArray("filaments"))
				if (one.getAsJsonObject().get("filament").getAsInt() == filament)
					return number(one.getAsJsonObject(), "length_uncertainty").orElse(0.0);
		return number(found, "length_uncertainty").orElse(0.0);
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
