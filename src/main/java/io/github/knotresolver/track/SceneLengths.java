
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Workers;

/**
 * How long the filaments of a pass are: in frames spread over the movie, as far as a filament is
 * clear there, it is fitted once more with its length free and all others drawn. A seed knows
 * lengths from three frames only, in which ends may lie on other filaments.
 */
final class SceneLengths {

	private final SceneLine line;
	private final SceneWeights weights;

	SceneLengths(final SceneLine line, final SceneWeights weights) {
		this.line = line;
		this.weights = weights;
	}

	/**
	 * The length of a filament.
	 *
	 * @param length in pixels
	 * @param error its standard error in pixels; NaN if no frame told it
	 * @param step another length before some frame than after it; empty if it stays
	 */
	record Length(double length, double error, Optional<LengthStep> step) {
	}

	/**
	 * Lengths before some frame and after it: halves of two filaments that have been exchanged show
	 * so, however well each frame is explained.
	 *
	 * @param before in pixels
	 * @param after in pixels
	 */
	record LengthStep(double before, double after) {

		private double by() {
			return after - before;
		}

		/** Whether one filament gets shorter by what the other gets longer. */
		boolean balances(final LengthStep other) {
			return by() * other.by() < 0 && Math.abs(by() + other.by()) < SceneTuning.LENGTH_STEP;
		}
	}

	/**
	 * The filaments where a pass began, as long as they are; empty if the pass had all lengths
	 * right.
	 */
	Optional<List<Chain>> corrected(final PricedPass priced, final Workers workers) {
		final ScenePass pass = priced.pass();
		final List<Length> lengths = of(pass, priced.clear(), workers);
		final List<Chain> before = pass.chains().get(pass.start()), chains = new ArrayList<>();
		boolean isRight = true;
		for (int k = 0; k < before.size(); k++) {
			final double length = lengths.get(k).length;
			final double off = Math.abs(length - before.get(k).length());
			isRight &= off < Math.max(SceneTuning.LENGTH_OFF,
				SceneTuning.LENGTH_OFF_SHARE * length);
			chains.add(Chain.inScene(before.get(k).polyline(), length));
		}
		if (isRight)
			return Optional.empty();
		final Scene scene = line.scene(pass.start(), chains);
		for (int sweep = 0; sweep < SceneTuning.LENGTH_SWEEPS; sweep++)
			for (int k = 0; k < scene.size(); k++) {
				final Chain chain = scene.chain(k);
				scene.take(k);
				scene.put(k, scene.window(List.of(chain))
					.fit(chain, Optional.of(chain), weights.tracked()).chain());
			}
		return Optional.of(scene.chains());
	}

	/**
	 * The lengths of all filaments; O(filaments) for a frame, in at most 24 frames.
	 *
	 * @param clear for each filament and frame whether the light around it is explained
	 */
	List<Length> of(final ScenePass pass, final boolean[][] clear, final Workers workers) {
		return of(pass, IntStream.range(0, pass.filaments()).boxed().toList(), clear, workers);
	}

	/** The lengths of some filaments, in their order. */
	List<Length> of(final ScenePass pass, final List<Integer> which, final boolean[][] clear,
		final Workers workers) {
		final int[] looks = looks(pass.chains().size());
		final List<double[]> found = workers.map(looks.length,
			i -> lengths(pass, which, looks[i], clear));
		final List<Length> all = new ArrayList<>();
		for (int i = 0; i < which.size(); i++) {
			final int filament = i;
			final double[] seen = found.stream().mapToDouble(f -> f[filament])
				.filter(Double::isFinite).toArray();
			all.add(seen.length < SceneTuning.LENGTH_FEWEST
				? new Length(pass.chains().get(0).get(which.get(i)).length(), Double.NaN,
					Optional.empty())
				: length(seen));
		}
		return all;
	}

	/** The frames, spread over a movie, in which lengths are measured. */
	static int[] looks(final int frames) {
		final int stride = 1 + (frames - 1) / SceneTuning.LENGTH_LOOKS;
		return IntStream.iterate(0, t -> t < frames, t -> t + stride).toArray();
	}

	private static Length length(final double[] seen) {
		return new Length(new Median().evaluate(seen),
			scatter(seen) * RobustStatistics.MEDIAN_TO_MEAN_ERROR / Math.sqrt(seen.length),
			step(seen));
	}

	/** The largest step of lengths in order of time that is beyond doubt; empty if none is. */
	static Optional<LengthStep> step(final double[] seen) {
		LengthStep largest = new LengthStep(0, 0);
		for (int from = SceneTuning.LENGTH_ASIDE; from <= seen.length
			- SceneTuning.LENGTH_ASIDE; from++) {
			final double[] before = Arrays.copyOf(seen, from);
			final double[] after = Arrays.copyOfRange(seen, from, seen.length);
			final LengthStep step = new LengthStep(new Median().evaluate(before),
				new Median().evaluate(after));
			final double by = Math.abs(step.by());
			if (by > Math.max(SceneTuning.LENGTH_STEP, Math.abs(largest.by()))
				&& by > SceneTuning.LENGTH_CLEARLY * Math.min(scatter(before), scatter(after)))
				largest = step;
		}
		return largest.by() == 0 ? Optional.empty() : Optional.of(largest);
	}

	static double scatter(final double[] lengths) {
		final double middle = new Median().evaluate(lengths);
		return RobustStatistics.MAD_TO_SD * new Median()
			.evaluate(Arrays.stream(lengths).map(l -> Math.abs(l - middle)).toArray());
	}

	/** The lengths in a frame; NaN where a filament is not clear. */
	private double[] lengths(final ScenePass pass, final List<Integer> which, final int t,
		final boolean[][] clear) {
		final Scene scene = line.scene(t, pass.chains().get(t));
		final double[] lengths = new double[which.size()];
		Arrays.fill(lengths, Double.NaN);
		for (int i = 0; i < lengths.length; i++) {
			final int k = which.get(i);
			if (clear[k][t]) {
				final Chain chain = scene.chain(k);
				scene.take(k);
				lengths[i] = scene.window(List.of(chain))
					.fit(chain, Optional.empty(), weights.free()).chain().length();
				scene.put(k, chain);
			}
		}
		return lengths;
	}
}
