package io.github.knotresolver.io;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.geometry.Calibration;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.ContourGeometry;
import io.github.knotresolver.measure.Smoothing;
import io.github.knotresolver.pipeline.Resolution;
import io.github.knotresolver.track.TrackedFrame;

/**
 * A frame of a result with its contour's geometry.
 *
 * @param tracked what was found
 * @param geometry its geometry in calibrated units; empty without a contour
 *          that can be measured
 */
public record MeasuredFrame(TrackedFrame tracked, Optional<ContourGeometry> geometry) {

	/**
	 * Measures all frames of a result with one smoothing for the whole movie.
	 *
	 * @param resolution a result
	 * @return its frames, in order
	 */
	public static List<MeasuredFrame> of(final Resolution resolution) {
		final Calibration calibration = resolution.movie().calibration();
		final List<Polyline> contours = resolution.frames().stream()
			.flatMap(f -> f.contour().stream()).filter(ContourGeometry::isMeasurable).toList();
		if (contours.isEmpty())
			return resolution.frames().stream().map(f -> new MeasuredFrame(f, Optional.empty()))
				.toList();
		final Smoothing smoothing = Smoothing.derivedFrom(contours, calibration);
		return resolution.frames().stream()
			.map(f -> new MeasuredFrame(f, f.contour().filter(ContourGeometry::isMeasurable)
				.map(c -> ContourGeometry.of(c, calibration, smoothing))))
			.toList();
	}

	/** @return length in the unit of length; NaN if there is none */
	public double length() {
		return geometry.map(ContourGeometry::length).orElse(Double.NaN);
	}

	/** @return distance of the ends in the unit of length; NaN if there is none */
	public double endToEnd() {
		return geometry.map(ContourGeometry::endToEnd).orElse(Double.NaN);
	}

	/** @return tangent angle at the tip in radians; NaN if there is none */
	public double tipAngle() {
		return geometry.map(ContourGeometry::tipAngle).orElse(Double.NaN);
	}
}
