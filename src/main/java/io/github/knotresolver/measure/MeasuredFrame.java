package io.github.knotresolver.measure;

import java.util.Arrays;
import java.util.Optional;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;

/**
 * A frame of a result with its measurement.
 *
 * @param filament number of the filament
 * @param tracked what was found
 * @param measurement what was measured; empty without a contour that can be
 *          measured
 */
public record MeasuredFrame(int filament, Observation tracked,
	Optional<FrameMeasurement> measurement) {

	private static final double[] NOTHING = {};

	/**
	 * @param quantity what
	 * @return its value in calibrated units; NaN if it was not measured
	 */
	public double get(final Quantity quantity) {
		return measurement.map(m -> m.get(quantity).value()).orElse(Double.NaN);
	}

	/** @return length in the unit of length; NaN if there is none */
	public double length() {
		return get(Quantity.LENGTH);
	}

	/**
	 * @param pixelSize edge of a pixel in the unit of length
	 * @return columns of the smoothed contour, of which all other values are; of the
	 *         contour itself if it was not measured; none without a contour
	 */
	public double[] x(final double pixelSize) {
		return geometry().map(ContourGeometry::x).orElseGet(
			() -> scaled(tracked.contour().map(Polyline::xs).orElse(NOTHING), pixelSize));
	}

	/**
	 * @param pixelSize edge of a pixel in the unit of length
	 * @return rows, likewise
	 */
	public double[] y(final double pixelSize) {
		return geometry().map(ContourGeometry::y).orElseGet(
			() -> scaled(tracked.contour().map(Polyline::ys).orElse(NOTHING), pixelSize));
	}

	private static double[] scaled(final double[] values, final double factor) {
		return Arrays.stream(values).map(v -> v * factor).toArray();
	}

	/** @return arc length at each point; empty if it was not measured */
	public double[] arcLength() {
		return geometry().map(ContourGeometry::arcLength).orElse(NOTHING);
	}

	/** @return tangent angle at each point; empty if it was not measured */
	public double[] tangentAngle() {
		return geometry().isPresent() ? measurement.orElseThrow().tangentAngle() : NOTHING;
	}

	/** @return curvature at each point; empty if it was not measured */
	public double[] curvature() {
		return geometry().map(ContourGeometry::curvature).orElse(NOTHING);
	}

	private Optional<ContourGeometry> geometry() {
		return measurement.flatMap(FrameMeasurement::geometry);
	}
}
