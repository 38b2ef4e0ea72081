package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;

/**
 * Judges the contours of a real movie without truth: a stabilised filament keeps its
 * length, turns continuously and stays clamped. The definitions are those of the
 * benchmark's independent scorer, so that figures can be compared.
 *
 * @param lengthVariation standard deviation of the length over its mean
 * @param off 1-based frames whose length is more than 10 % from the median, or that
 *          have no contour
 * @param jumps 1-based frames whose total turning differs from the frame's before by
 *          more than 200 degrees: a loop lost, or run the wrong way
 * @param endStep largest step of the fixed end between neighbouring frames in pixels
 */
record Consistency(double lengthVariation, List<Integer> off, List<Integer> jumps, double endStep) {

	private static final double OFF = 0.1, JUMP = Math.toRadians(200);
	private static final double SIGMA = 2;
	private static final int RADIUS = 8;
	private static final int MARGIN = 6;

	static Consistency of(final List<Observation> frames) {
		final List<Observation> seen = frames.stream().filter(f -> f.contour().isPresent())
			.toList();
		final List<Polyline> curves = seen.stream().map(f -> f.contour().orElseThrow()).toList();
		final double[] lengths = curves.stream().mapToDouble(c -> smooth(c).length()).toArray();
		final double median = median(lengths);
		final List<Integer> off = new ArrayList<>(
			frames.stream().filter(f -> f.contour().isEmpty()).map(Observation::frame).toList());
		final List<Integer> jumps = new ArrayList<>();
		double endStep = 0;
		for (int i = 0; i < lengths.length; i++) {
			if (Math.abs(lengths[i] / median - 1) > OFF)
				off.add(seen.get(i).frame());
			if (i == 0)
				continue;
			if (Math.abs(turning(curves.get(i)) - turning(curves.get(i - 1))) > JUMP)
				jumps.add(seen.get(i).frame());
			endStep = Math.max(endStep,
				curves.get(i).first().distanceTo(curves.get(i - 1).first()));
		}
		return new Consistency(variation(lengths), off, jumps, endStep);
	}

	private static double variation(final double[] values) {
		final double mean = Arrays.stream(values).average().orElseThrow();
		return Math.sqrt(
			Arrays.stream(values).map(v -> (v - mean) * (v - mean)).average().orElseThrow()) / mean;
	}

	private static double median(final double[] values) {
		final double[] v = values.clone();
		Arrays.sort(v);
		return (v[(v.length - 1) / 2] + v[v.length / 2]) / 2;
	}

	/** The curve at 1 px, smoothed; its ends are mirrored so that they stay. */
	private static Polyline smooth(final Polyline curve) {
		final Polyline even = curve.resampled(1);
		return Polyline.of(smoothed(even.xs()), smoothed(even.ys()));
	}

	private static double[] smoothed(final double[] v) {
		final int n = v.length;
		final double[] extended = new double[n + 2 * MARGIN];
		for (int i = 0; i < extended.length; i++) {
			final int at = i - MARGIN;
			extended[i] = at < 0
				? 2 * v[0] - v[-at]
				: at < n ? v[at] : 2 * v[n - 1] - v[2 * (n - 1) - at];
		}
		return Arrays.copyOfRange(gaussian(extended), MARGIN, MARGIN + n);
	}

	/** A Gaussian of sigma 2, the values mirrored beyond the ends. */
	private static double[] gaussian(final double[] v) {
		final double[] out = new double[v.length];
		double total = 0;
		for (int k = -RADIUS; k <= RADIUS; k++) {
			final double weight = Math.exp(-k * k / (2 * SIGMA * SIGMA));
			total += weight;
			for (int i = 0; i < v.length; i++) {
				final int at = i + k;
				out[i] += weight * v[at < 0 ? -at - 1 : at < v.length ? at : 2 * v.length - at - 1];
			}
		}
		for (int i = 0; i < v.length; i++)
			out[i] /= total;
		return out;
	}

	/** Total turning along the contour in radians. */
	private static double turning(final Polyline curve) {
		final Polyline smooth = smooth(curve);
		final Polyline p = Polyline.of(gaussian(smooth.xs()), gaussian(smooth.ys())).resampled(2);
		double turned = 0;
		for (int i = 2; i < p.size(); i++) {
			final double d = angle(p, i) - angle(p, i - 1);
			turned += d - 2 * Math.PI * Math.rint(d / (2 * Math.PI));
		}
		return turned;
	}

	private static double angle(final Polyline p, final int i) {
		return Math.atan2(p.y(i) - p.y(i - 1), p.x(i) - p.x(i - 1));
	}
}
