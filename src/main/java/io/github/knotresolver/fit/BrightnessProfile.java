package io.github.knotresolver.fit;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;

import io.github.knotresolver.fit.LineEstimator.Example;
import io.github.knotresolver.fit.LineEstimator.LineEstimate;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * How bright the filament is along its length, relative to its mean: a dim tip is still
 * the tip. The profile is piecewise linear; as the picture of a chain is linear in its
 * brightness, it follows from linear least squares over all examples, held near 1 where
 * the pictures say little. If it is noticeable so, it is held straight instead of near 1: a
 * dim tip that is taken for brighter than it is makes the fitted curve end before it. For the
 * same reason its knots are closer near the ends, where a filament may taper.
 */
final class BrightnessProfile {

	private final List<Example> examples;
	private final LineEstimate line;
	private final double length;

	private BrightnessProfile(final List<Example> examples, final LineEstimate line) {
		this.examples = examples;
		this.line = line;
		length = examples.get(0).chain().length();
	}

	/**
	 * @param examples frames and curves
	 * @param line the line, uniform
	 * @return relative brightness at equal spacing from the fixed end to the tip
	 */
	static double[] estimate(final List<Example> examples, final LineEstimate line) {
		return new BrightnessProfile(examples, line).estimate();
	}

	/**
	 * How bright a filament is, and how much longer than curves that are all as long.
	 *
	 * @param brightness relative brightness at equal spacing from the fixed end to the tip
	 * @param missing at the tip, to first order, in pixels; negative if the filament is shorter
	 */
	record Lengthened(double[] brightness, double missing) {
	}

	/**
	 * How bright the end is and where it is are found together: a dim end that is taken for brighter
	 * than it is lies before it.
	 *
	 * @param examples frames and curves, all as long
	 * @param line the line, which adds up
	 * @return what explains the examples best
	 */
	static Lengthened lengthened(final List<Example> examples, final LineEstimate line) {
		return new BrightnessProfile(examples, line).lengthened();
	}

	/**
	 * @param brightness relative brightness at equal spacing
	 * @return whether it is all but dark somewhere, and far brighter on both sides of that
	 */
	static boolean isBroken(final double[] brightness) {
		final double[] after = brightness.clone();
		for (int i = after.length - 2; i >= 0; i--)
			after[i] = Math.max(after[i], after[i + 1]);
		double before = 0;
		for (int i = 0; i < brightness.length; i++) {
			before = Math.max(before, brightness[i]);
			if (brightness[i] < FitTuning.GAP
				&& Math.min(before, after[i]) > FitTuning.BEYOND_GAP * brightness[i])
				return true;
		}
		return false;
	}

	/**
	 * @param brightness relative brightness at equal spacing
	 * @param length of the filament in pixels
	 * @return whether an end of it is so bright that something else must lie there: brighter than a
	 *         strand is, or than what is just before it, which is dimmer than what is before that
	 */
	static boolean hasBrightEnd(final double[] brightness, final double length) {
		final int near = (int) Math.rint(FitTuning.KNOT_SPACING * (brightness.length - 1) / length);
		return Math.max(brightness[0], brightness[brightness.length - 1]) > FitTuning.BRIGHT_END
			|| hasSpotAtEnd(i -> brightness[i], near, brightness.length)
			|| hasSpotAtEnd(i -> brightness[brightness.length - 1 - i], near, brightness.length);
	}

	private static boolean hasSpotAtEnd(final IntToDoubleFunction fromEnd, final int near,
		final int size) {
		int dip = 0;
		for (int i = 0; i <= Math.min(near, size - 1); i++)
			if (fromEnd.applyAsDouble(i) < fromEnd.applyAsDouble(dip))
				dip = i;
		double before = 0;
		for (int i = dip; i <= Math.min(2 * near, size - 1); i++)
			before = Math.max(before, fromEnd.applyAsDouble(i));
		final double dark = fromEnd.applyAsDouble(dip);
		return fromEnd.applyAsDouble(0) > FitTuning.SPOT_AT_END * dark
			&& before > FitTuning.BEFORE_SPOT * dark;
	}

	private double[] estimate() {
		final double weight = FitTuning.PROFILE_HOLD * examples.size();
		final double[] even = evenKnots();
		final Normal held = new Normal(even, false);
		held.hold(weight);
		final boolean varies = varies(held.solved());
		final double[] knots = line.model().kind() == LineModel.Kind.ADDITIVE
			? withEnds(even)
			: even;
		final double[] profile = heldStraight(even, knots, FitTuning.PROFILE_PULL, false);
		if (!varies && profile[0] > FitTuning.DIM_END
			&& profile[profile.length - 1] > FitTuning.DIM_END)
			return new double[]{1};
		return sampled(knots, profile);
	}

	private double[] sampled(final double[] knots, final double[] profile) {
		final double[] sampled = new double[1 + (int) Math.ceil(length)];
		for (int i = 0; i < sampled.length; i++)
			sampled[i] = at((double) i / (sampled.length - 1), knots, profile);
		return sampled;
	}

	/**
	 * The brightness at the knots.
	 *
	 * @param pull weight of a brightness of 1
	 * @param withTip whether the light that is missing at the tip comes after it
	 */
	private double[] heldStraight(final double[] even, final double[] knots, final double pull,
		final boolean withTip) {
		final double weight = FitTuning.PROFILE_HOLD * examples.size();
		final Normal straight = new Normal(knots, withTip);
		straight.hold(pull * weight);
		straight.holdStraight(even, weight,
			Math.min(1, line.residual() / FitTuning.END_MISFIT) * weight);
		return straight.solved();
	}

	private Lengthened lengthened() {
		final double[] even = evenKnots(), knots = withEnds(even);
		final double[] profile = heldStraight(even, knots, FitTuning.LENGTHENED_PULL, true);
		return new Lengthened(sampled(knots, profile),
			profile[knots.length] / limited(profile[knots.length - 1]));
	}

	/** Places of knots at equal spacing, as shares of the length. */
	private double[] evenKnots() {
		final int knots = Math.max(FitTuning.FEWEST_KNOTS,
			Math.min(FitTuning.MOST_KNOTS, 1 + (int) Math.rint(length / FitTuning.KNOT_SPACING)));
		return IntStream.range(0, knots).mapToDouble(k -> (double) k / (knots - 1)).toArray();
	}

	/** The same and more of them near both ends. */
	private double[] withEnds(final double[] even) {
		final DoubleStream.Builder knots = DoubleStream.builder();
		for (final double knot : even)
			knots.add(knot);
		for (final double from : new double[]{FitTuning.END_KNOT, FitTuning.SECOND_END_KNOT,
			FitTuning.THIRD_END_KNOT})
			if (from < FitTuning.END_KNOTS_ROOM * even[1] * length) {
				knots.add(from / length);
				knots.add(1 - from / length);
			}
		return knots.build().sorted().toArray();
	}

	private static double at(final double place, final double[] knots, final double[] values) {
		final int found = Arrays.binarySearch(knots, place);
		if (found >= 0)
			return limited(values[found]);
		final int next = -found - 1;
		final double share = (place - knots[next - 1]) / (knots[next] - knots[next - 1]);
		return (1 - share) * limited(values[next - 1]) + share * limited(values[next]);
	}

	private static double limited(final double value) {
		return Math.max(FitTuning.DIMMEST, Math.min(FitTuning.BRIGHTEST, value));
	}

	private static boolean varies(final double[] profile) {
		return Arrays.stream(profile).anyMatch(b -> Math.abs(b - 1) > FitTuning.UNEVEN);
	}

	/** The normal equations of the brightness at knots. */
	private final class Normal {

		private final double[] knots;
		private final double[][] matrix;
		private final double[] right;

		Normal(final double[] knots, final boolean withTip) {
			this.knots = knots;
			final int unknown = knots.length + (withTip ? 1 : 0);
			matrix = new double[unknown][unknown];
			right = new double[unknown];
			examples.forEach(this::add);
		}

		/** Draws all knots towards 1. */
		void hold(final double weight) {
			for (int k = 0; k < knots.length; k++) {
				matrix[k][k] += weight;
				right[k] += weight;
			}
		}

		/**
		 * Draws every knot towards the line through its neighbours.
		 *
		 * @param even those at equal spacing
		 * @param weight of these
		 * @param end weight of the others
		 */
		void holdStraight(final double[] even, final double weight, final double end) {
			for (int k = 1; k + 1 < knots.length; k++) {
				final double hold = Arrays.binarySearch(even, knots[k]) < 0 ? end : weight;
				final double share = (knots[k] - knots[k - 1]) / (knots[k + 1] - knots[k - 1]);
				final double[] bend = {share - 1, 1, -share};
				for (int i = 0; i < bend.length; i++)
					for (int j = 0; j < bend.length; j++)
						matrix[k - 1 + i][k - 1 + j] += hold * bend[i] * bend[j];
			}
		}

		double[] solved() {
			return new CholeskyDecomposition(new Array2DRowRealMatrix(matrix, true)).getSolver()
				.solve(new ArrayRealVector(right, true)).toArray();
		}

		private void add(final Example example) {
			final LineEstimator.Around around = example.around();
			final double[][] pictures = IntStream.range(0, right.length)
				.mapToObj(k -> k < knots.length
					? ChainPixels.draw(example.frame(), line.model().withBrightness(hat(k)),
						example.chain(), around.patch())
					: ChainPixels.draw(example.frame(),
						line.model().withBrightness(new double[]{1}), lastPixel(example.chain()),
						around.patch()))
				.toArray(double[][]::new);
			final double[] pixels = around.part().pixels();
			for (int i = 0; i < pixels.length; i++)
				if (around.near()[i] && !isCutOff(around.part(), i, pictures))
					add(pictures, i, (pixels[i] - line.background()) / line.amplitude());
		}

		/** A pixel's length around the tip, going on straight. */
		private Chain lastPixel(final Chain chain) {
			final Point tip = chain.tip();
			final double angle = chain.angle(chain.links() - 1);
			final double dx = 0.5 * Math.cos(angle), dy = 0.5 * Math.sin(angle);
			return Chain.along(Polyline.of(List.of(new Point(tip.x() - dx, tip.y() - dy),
				new Point(tip.x() + dx, tip.y() + dy))), 2, 1);
		}

		/** What is 1 at a knot and 0 at all others. */
		private double[] hat(final int knot) {
			final double[] hat = new double[1 + 2 * (int) Math.ceil(length)];
			for (int i = 0; i < hat.length; i++) {
				final double place = (double) i / (hat.length - 1);
				final double edge = place < knots[knot]
					? knots[Math.max(0, knot - 1)]
					: knots[Math.min(knots.length - 1, knot + 1)];
				hat[i] = place == knots[knot]
					? 1
					: Math.max(0, 1 - (place - knots[knot]) / (edge - knots[knot]));
			}
			return hat;
		}

		private void add(final double[][] pictures, final int at, final double value) {
			for (int k = 0; k < right.length; k++) {
				if (pictures[k][at] == 0)
					continue;
				right[k] += pictures[k][at] * value;
				for (int m = 0; m < right.length; m++)
					matrix[k][m] += pictures[k][at] * pictures[m][at];
			}
		}

		/** Whether a line as it is expected is cut off somewhere. */
		private boolean isCutOff(final NormalizedFrame frame, final int at,
			final double[][] pictures) {
			double uniform = 0;
			for (final double[] picture : pictures)
				uniform += picture[at];
			return line.model().kind() == LineModel.Kind.ADDITIVE
				&& frame.hides(at, line.background() + line.amplitude() * uniform);
		}
	}
}
