package io.github.knotresolver.io;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;

/**
 * A result as its folder tells it, to be looked at: contours to the third decimal of a pixel, and no
 * alternatives.
 */
public final class FinishedTracks {

	private final NamedTable frames, filaments;
	private final SortedMap<Integer, SortedMap<Integer, Polyline>> contours;
	private final double pixelSize;

	private FinishedTracks(final Path folder, final double pixelSize) {
		frames = NamedTable.read(folder.resolve(FramesCsv.FILE));
		filaments = NamedTable.read(folder.resolve(FilamentsCsv.FILE));
		contours = ContoursCsv.readFilaments(folder.resolve(ContoursCsv.FILE));
		this.pixelSize = pixelSize;
	}

	/**
	 * @param folder a result folder
	 * @param movie its movie
	 * @param settings what it was resolved with
	 * @return the result; empty if its tables are not those of this version, or do not fit the movie
	 */
	public static Optional<Tracks> read(final Path folder, final Movie movie,
		final Settings settings) {
		try {
			final FinishedTracks files = new FinishedTracks(folder,
				movie.calibration().pixelSize());
			return Optional.of(new Tracks(movie, settings, files.tracks(movie.size()), List.of()));
		} catch (final UserException | IllegalArgumentException e) {
			// The movie is solved again in any case; until then there is nothing to look at.
			return Optional.empty();
		}
	}

	private List<FilamentTrack> tracks(final int size) {
		final Map<Integer, Observation[]> observed = new TreeMap<>();
		for (final CsvFile.Row row : frames.rows()) {
			final int filament = (int) frames.number(row, ContoursCsv.FILAMENT),
				frame = (int) frames.number(row, "frame");
			if (frame < 1 || frame > size)
				throw new IllegalArgumentException("frame " + frame);
			observed.computeIfAbsent(filament, f -> new Observation[size])[frame - 1] = observation(
				row, filament, frame);
		}
		final List<FilamentTrack> tracks = new ArrayList<>();
		for (final CsvFile.Row row : filaments.rows()) {
			final int id = (int) filaments.number(row, ContoursCsv.FILAMENT);
			tracks.add(new FilamentTrack(id,
				Anchor.valueOf(filaments.text(row, "anchor").toUpperCase(Locale.ROOT)),
				Optional.empty(), filaments.number(row, "length") / pixelSize,
				filaments.number(row, "length_se") / pixelSize,
				Arrays.asList(complete(observed.get(id)))));
		}
		return tracks;
	}

	private static Observation[] complete(final Observation[] rows) {
		if (rows == null || Arrays.asList(rows).contains(null))
			throw new IllegalArgumentException("A frame is missing.");
		return rows;
	}

	private Observation observation(final CsvFile.Row row, final int filament, final int frame) {
		final double visible = frames.number(row, "visible");
		return new Observation(frame,
			FrameStatus.valueOf(frames.text(row, "status").toUpperCase(Locale.ROOT)),
			frames.text(row, "reason"),
			Optional.ofNullable(contours.getOrDefault(filament, new TreeMap<>()).get(frame)),
			(int) frames.number(row, "junctions"), (int) frames.number(row, "candidates"),
			frames.number(row, "cost"), frames.number(row, "confidence"),
			Double.isNaN(visible) ? 1 : visible, List.of());
	}
}
