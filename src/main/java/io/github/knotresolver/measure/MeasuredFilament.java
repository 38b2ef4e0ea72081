package io.github.knotresolver.measure;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;

/**
 * One filament of a result with what was measured of it.
 *
 * @param track the filament
 * @param measurements of its contours; empty if none can be measured
 * @param frames the frames of the movie in order
 */
public record MeasuredFilament(FilamentTrack track, Optional<MovieMeasurements> measurements,
	List<MeasuredFrame> frames) {

	public MeasuredFilament {
		frames = List.copyOf(frames);
	}

	/**
	 * @param movie the movie
	 * @param track a filament in it
	 * @param name what its measurements are called
	 * @param progress told how far it is
	 * @return it, measured
	 */
	static MeasuredFilament of(final Movie movie, final FilamentTrack track, final String name,
		final Progress progress) {
		final List<Optional<Polyline>> contours = track.frames().stream().map(Observation::contour)
			.toList();
		final boolean measurable = contours.stream()
			.anyMatch(c -> c.filter(ContourGeometry::isMeasurable).isPresent());
		final Optional<MovieMeasurements> measurements = measurable
			? Optional.of(MovieMeasurements.of(name, contours, movie.calibration(),
				Optional.empty(), Rigidity.UNKNOWN, lengthError(movie, track), progress))
			: Optional.empty();
		return new MeasuredFilament(track, measurements,
			IntStream.range(0, contours.size()).mapToObj(i -> new MeasuredFrame(track.id(),
				track.frames().get(i), measurements.map(m -> m.frames().get(i)))).toList());
	}

	private static double lengthError(final Movie movie, final FilamentTrack track) {
		final double error = track.lengthError();
		return Double.isFinite(error) ? error * movie.calibration().pixelSize() : 0;
	}

	/** @return the tip angle's dominant frequency; empty if it has none */
	public Optional<DominantFrequency> dominantFrequency() {
		return measurements.flatMap(m -> m.dominantFrequency(Quantity.TIP_ANGLE));
	}

	/**
	 * What the names of a filament's own files have before their ending.
	 *
	 * @param id number of the filament
	 * @return such as {@code -02}; nothing for filament 1, whose files have the names of
	 *         those of a movie with one filament
	 */
	public static String suffix(final int id) {
		return id == 1 ? "" : "-" + number(id);
	}

	/**
	 * @param id number of a filament
	 * @return it with two digits or more, so that names sort
	 */
	public static String number(final int id) {
		return String.format(Locale.ROOT, "%02d", id);
	}
}
