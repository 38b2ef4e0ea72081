package io.github.knotresolver.imagej.accuracy;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;

import io.github.knotresolver.evaluate.CurveScore;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.Estimate;
import io.github.knotresolver.measure.FrameMeasurement;
import io.github.knotresolver.measure.Quantity;

/** How often intervals of one standard error × 1.96 hold the truth. */
final class Coverage {

	/** Half the width of a 95 % interval, in standard errors. */
	static final double HALF_WIDTH = 1.96;

	/** Errors of one quantity. */
	static final class Tally {

		private int cases;
		private int covered;
		private double error;
		private double square;
		private double relative;

		void add(final double off, final double standardError, final double truth) {
			cases++;
			if (Math.abs(off) < HALF_WIDTH * standardError)
				covered++;
			error += off;
			square += off * off;
			relative += off / truth;
		}

		void add(final Tally other) {
			cases += other.cases;
			covered += other.covered;
			error += other.error;
			square += other.square;
			relative += other.relative;
		}

		int cases() {
			return cases;
		}

		double covered() {
			return covered / (double) cases;
		}

		double meanError() {
			return error / cases;
		}

		double meanRelativeError() {
			return relative / cases;
		}

		double rms() {
			return Math.sqrt(square / cases);
		}

		/** Covered part and root mean square error. */
		String cell() {
			return cases == 0
				? "-"
				: String.format(Locale.ROOT, "%.0f %% (%.3g)", 100 * covered(), rms());
		}
	}

	private final Map<Quantity, Tally> tallies = new EnumMap<>(Quantity.class);
	private int frames;
	private int wrong;

	Coverage() {
		for (final Quantity q : Quantity.values())
			tallies.put(q, new Tally());
	}

	Tally of(final Quantity quantity) {
		return tallies.get(quantity);
	}

	/** Frames that were measured and have the right contour. */
	int frames() {
		return frames;
	}

	/** Frames whose contour is another one: they cannot be covered. */
	int wrong() {
		return wrong;
	}

	void add(final Coverage other) {
		frames += other.frames;
		wrong += other.wrong;
		tallies.forEach((q, tally) -> tally.add(other.of(q)));
	}

	/**
	 * @param measured a frame
	 * @param result its contour, px
	 * @param truth the true contour, px, smooth and finely sampled
	 * @param pixelSize in the unit of length
	 */
	void add(final FrameMeasurement measured, final Polyline result, final Polyline truth,
		final double pixelSize) {
		if (!CurveScore.of(truth, result).isResolved()) {
			wrong++;
			return;
		}
		frames++;
		final Map<Quantity, Double> exact = Exact.of(truth, pixelSize);
		exact.forEach((q, value) -> {
			final Estimate e = measured.get(q);
			final double off = e.value() - value;
			of(q).add(q == Quantity.TIP_ANGLE ? Math.IEEEremainder(off, 2 * Math.PI) : off,
				e.standardError(), value);
		});
	}
}
