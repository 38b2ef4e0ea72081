
package io.github.knotresolver.measure;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Unwraps tangent angles from frame to frame. */
final class Turns {

	private Turns() {
	}

	/**
	 * Whole turns to add to each contour's angles so that they are nearest, in the
	 * median over the contour, to those of the last frame that has a contour.
	 */
	static int[] between(final List<Optional<ContourGeometry>> contours) {
		final int[] turns = new int[contours.size()];
		double[] last = null;
		for (int i = 0; i < turns.length; i++) {
			if (contours.get(i).isEmpty())
				continue;
			final double[] angles = profile(contours.get(i).orElseThrow());
			if (last != null)
				turns[i] = turns(angles, last);
			for (int k = 0; k < MeasureTuning.TURN_PLACES; k++)
				angles[k] += 2 * Math.PI * turns[i];
			last = angles;
		}
		return turns;
	}

	private static int turns(final double[] angles, final double[] last) {
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
