package io.github.knotresolver.io;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Calibration;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.ContourGeometry;
import io.github.knotresolver.measure.DominantFrequency;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.measure.Rigidity;
import io.github.knotresolver.pipeline.Resolution;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.track.TrackedFrame;

/**
 * A result with what was measured of it: what all writers and tables start
 * from.
 *
 * @param resolution the result
 * @param measurements of its contours; empty if none can be measured
 * @param frames the frames in order
 */
public record MeasuredResolution(Resolution resolution, Optional<MovieMeasurements> measurements,
	List<MeasuredFrame> frames) {

	/**
	 * @param resolution a result
	 * @param progress told how far it is
	 * @return it, measured
	 */
	public static MeasuredResolution of(final Resolution resolution, final Progress progress) {
		final List<Optional<Polyline>> contours = resolution.frames().stream()
			.map(TrackedFrame::contour).toList();
		if (contours.stream().noneMatch(c -> c.filter(ContourGeometry::isMeasurable).isPresent()))
			return new MeasuredResolution(resolution, Optional.empty(), resolution.frames().stream()
				.map(f -> new MeasuredFrame(f, Optional.empty())).toList());
		final MovieMeasurements measurements = MovieMeasurements.of(resolution.movie().name(),
			contours, resolution.movie().calibration(), Optional.empty(), Rigidity.UNKNOWN,
			lengthError(resolution), progress);
		return new MeasuredResolution(resolution, Optional.of(measurements),
			IntStream.range(0, contours.size())
				.mapToObj(i -> new MeasuredFrame(resolution.frames().get(i),
					Optional.of(measurements.frames().get(i))))
				.toList());
	}

	private static double lengthError(final Resolution resolution) {
		final double error = resolution.lengthUncertainty();
		return Double.isFinite(error) ? error * resolution.movie().calibration().pixelSize() : 0;
	}

	/** @return units of length and time */
	public Calibration calibration() {
		return resolution.movie().calibration();
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
