
package io.github.knotresolver.measure;

import java.util.List;

import io.github.knotresolver.progress.Cancellation;

/** Cross-validation of the smoothing's window. */
final class WindowChoice {

	private static final int ORDER = Smoothing.DEFAULT_ORDER;

	private final List<Samples> contours;
	private final double pixelSize;
	private final int stride;

	WindowChoice(final List<Samples> contours, final double pixelSize) {
		this.contours = contours;
		this.pixelSize = pixelSize;
		final int points = contours.stream().mapToInt(Samples::size).sum();
		this.stride = Math.max(1, points / MeasureTuning.PREDICTIONS);
	}

	/** @param gap neighbours within this distance are left out with a point */
	Smoothing best(final double gap) {
		final double widest = contours.stream().mapToDouble(Samples::length).max().orElseThrow();
		final double narrowest = Math.min(widest, MeasureTuning.NARROWEST_WINDOW * pixelSize);
		double best = narrowest, least = Double.POSITIVE_INFINITY;
		for (double w = narrowest; w <= widest * (1 + 1e-9); w *= MeasureTuning.WINDOW_STEP) {
			Cancellation.check();
			final double error = predictionError(w, gap);
			if (error > MeasureTuning.WINDOW_HOPELESS * least)
				break;
			if (error < least) {
				least = error;
				best = w;
			}
		}
		return new Smoothing(Math.max(narrowest, best * MeasureTuning.NARROWER), ORDER);
	}

	/** Mean squared error of prediction with a smoothing that was chosen. */
	double error(final Smoothing smoothing, final double gap) {
		return predictionError(smoothing.window(), gap);
	}

	/** Mean squared distance, across the curve, from the prediction. */
	private double predictionError(final double window, final double gap) {
		final LocalPolynomial fit = new LocalPolynomial(ORDER);
		double sum = 0;
		int n = 0, next = 0, seen = 0;
		for (final Samples c : contours) {
			Cancellation.check();
			for (; next < seen + c.size(); next += stride) {
				final double e = error(c, next - seen, window, gap, fit);
				if (Double.isNaN(e))
					continue;
				sum += e;
				n++;
			}
			seen += c.size();
		}
		return n == 0 ? Double.POSITIVE_INFINITY : sum / n;
	}

	/** NaN near an end, where prediction would be extrapolation. */
	private double error(final Samples c, final int i, final double window, final double gap,
		final LocalPolynomial fit) {
		final double s = c.s(i);
		final int[] w = c.window(s, window, 2 * ORDER + 4 + (int) (2 * gap / c.spacing()));
		if (s - c.s(w[0]) < 2 * gap || c.s(w[1] - 1) - s < 2 * gap)
			return Double.NaN;
		fit.fit(c, w[0], w[1], s, window / 2, gap);
		final double tx = fit.x(1), ty = fit.y(1);
		final double across = (c.x(i) - fit.x(0)) * ty - (c.y(i) - fit.y(0)) * tx;
		return across * across / (tx * tx + ty * ty);
	}
}
