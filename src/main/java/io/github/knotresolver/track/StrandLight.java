package io.github.knotresolver.track;

import java.util.Arrays;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.geometry.Polyline;

/** How bright a single strand is in a frame. */
final class StrandLight {

	/** Strands that lie on each other are brighter: a low quantile is that of one. */
	private static final double QUANTILE = 0.3;

	private StrandLight() {
	}

	/**
	 * @param frame the frame
	 * @param set its trails
	 * @return the brightness above the background along the best trail; NaN if there is
	 *         none
	 */
	static double of(final FrameView frame, final CandidateSet set) {
		if (set.candidates().isEmpty())
			return Double.NaN;
		final Polyline contour = ContourBuilder.smooth(set.candidates().get(0));
		final double[] light = new double[contour.size()];
		for (int i = 0; i < light.length; i++)
			light[i] = frame.light().meanAround(contour.x(i), contour.y(i));
		Arrays.sort(light);
		return light[(int) (QUANTILE * (light.length - 1))];
	}
}
