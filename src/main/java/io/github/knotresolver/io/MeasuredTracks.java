package io.github.knotresolver.io;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.ContourGeometry;
import io.github.knotresolver.measure.DominantFrequency;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.measure.Rigidity;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;

/**
 * A result with what was measured of it: what all writers and tables start
 * from.
 *
 * @param tracks the result
 * @param measurements of its contours; empty if none can be measured
 * @param frames the frames in order
 */
public record MeasuredTracks(Tracks tracks, Optional<MovieMeasurements> measurements,
	List<MeasuredFrame> frames) {

	/**
	 * @param tracks a result
	 * @param progress told how far it is
	 * @return it, measured
	 */
	public static MeasuredTracks of(final Tracks tracks, final Progress progress) {
		final List<Optional<Polyline>> contours = tracks.only().frames().stream()
			.map(Observation::contour).toList();
		if (contours.stream().noneMatch(c -> c.filter(ContourGeometry::isMeasurable).isPresent()))
			return new MeasuredTracks(tracks, Optional.empty(), tracks.only().frames().stream()
				.map(f -> new MeasuredFrame(f, Optional.empty())).toList());
		final MovieMeasurements measurements = MovieMeasurements.of(tracks.movie().name(),
			contours, tracks.movie().calibration(), Optional.empty(), Rigidity.UNKNOWN,
			lengthError(tracks), progress);
		return new MeasuredTracks(tracks, Optional.of(measurements),
			IntStream.range(0, contours.size())
				.mapToObj(i -> new MeasuredFrame(tracks.only().frames().get(i),
					Optional.of(measurements.frames().get(i))))
				.toList());
	}

	private static double lengthError(final Tracks tracks) {
		final double error = tracks.only().lengthError();
		return Double.isFinite(error) ? error * tracks.movie().calibration().pixelSize() : 0;
	}

	/** @return units of length and time */
	public Calibration calibration() {
		return tracks.movie().calibration();
	}

	/** @return the tip angle's dominant frequency; empty if it has none */
	public Optional<DominantFrequency> dominantFrequency() {
		return measurements.flatMap(m -> m.dominantFrequency(Quantity.TIP_ANGLE));
	}

	/** @return unit of frequencies: {@code Hz}, or {@code 1/unit of time} */
	String frequencyUnit() {
		return calibration().timeUnit().equals("s") ? "Hz" : "1/" + calibration().timeUnit();
	}
}
