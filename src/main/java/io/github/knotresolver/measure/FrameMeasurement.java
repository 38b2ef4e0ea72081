
package io.github.knotresolver.measure;

import java.util.Arrays;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Point;

/**
 * One frame, measured.
 *
 * @param frame 1-based number of the frame
 * @param geometry the contour's geometry; empty if the frame has no contour
 *          that can be measured
 * @param turns whole turns (2π) to add to the contour's angles so that they go
 *          on from the frame before
 * @param quantities the values; empty without a contour
 * @param crossings where the smoothed contour crosses itself, in pixels
 */
public record FrameMeasurement(int frame, Optional<ContourGeometry> geometry, int turns,
	Map<Quantity, Estimate> quantities, List<Point> crossings) {

	public FrameMeasurement {
		quantities = quantities.isEmpty()
			? Map.of()
			: Collections.unmodifiableMap(new EnumMap<>(quantities));
		crossings = List.copyOf(crossings);
	}

	/** A frame without contour. */
	static FrameMeasurement missing(final int frame) {
		return new FrameMeasurement(frame, Optional.empty(), 0, Map.of(), List.of());
	}

	/** A frame with its contour's geometry. */
	static FrameMeasurement of(final int frame, final ContourGeometry g, final int turns,
		final Rigidity rigidity, final double lengthError) {
		final List<Point> crossings = Crossings.of(g.smoothedPx());
		final Map<Quantity, Estimate> q = new FrameQuantities(g, lengthError).measured();
		q.put(Quantity.TIP_ANGLE, new Estimate(g.tipAngle() + 2 * Math.PI * turns,
			q.get(Quantity.TIP_ANGLE).standardError()));
		q.put(Quantity.BENDING_ENERGY, g.bendingIntegral().times(rigidity.value()));
		q.put(Quantity.CROSSINGS, new Estimate(crossings.size(), Double.NaN));
		return new FrameMeasurement(frame, Optional.of(g), turns, q, crossings);
	}

	/** @return whether the frame has a contour */
	public boolean isMeasured() {
		return geometry.isPresent();
	}

	/**
	 * @param quantity what
	 * @return its value; missing without a contour
	 */
	public Estimate get(final Quantity quantity) {
		return quantities.getOrDefault(quantity, Estimate.MISSING);
	}

	/** @return tangent angles, going on from the frame before; radians */
	public double[] tangentAngle() {
		final double[] angle = geometry.orElseThrow().tangentAngle();
		for (int i = 0; i < angle.length; i++)
			angle[i] += 2 * Math.PI * turns;
		return angle;
	}

	/**
	 * Unwraps tangent angles from frame to frame. Whole turns to add to each contour's angles so that they are nearest, in the
	 * median over the contour, to those of the last frame that has a contour.
	 */
	static int[] turnsBetween(final List<Optional<ContourGeometry>> contours) {
		final int[] turns = new int[contours.size()];
		double[] last = null;
		for (int i = 0; i < turns.length; i++) {
			if (contours.get(i).isEmpty())
				continue;
			final double[] angles = profile(contours.get(i).orElseThrow());
			if (last != null)
				turns[i] = nearest(angles, last);
			for (int k = 0; k < MeasureTuning.TURN_PLACES; k++)
				angles[k] += 2 * Math.PI * turns[i];
			last = angles;
		}
		return turns;
	}

	private static int nearest(final double[] angles, final double[] last) {
		final double[] difference = new double[MeasureTuning.TURN_PLACES];
		for (int k = 0; k < MeasureTuning.TURN_PLACES; k++)
			difference[k] = last[k] - angles[k];
		Arrays.sort(difference);
		return (int) Math.rint(difference[MeasureTuning.TURN_PLACES / 2] / (2 * Math.PI));
	}

	/** Angles at equal parts of the contour. */
	private static double[] profile(final ContourGeometry g) {
		final double[] angle = g.tangentAngle(), profile = new double[MeasureTuning.TURN_PLACES];
		for (int k = 0; k < MeasureTuning.TURN_PLACES; k++)
			profile[k] = angle[k * (angle.length - 1) / (MeasureTuning.TURN_PLACES - 1)];
		return profile;
	}
}
