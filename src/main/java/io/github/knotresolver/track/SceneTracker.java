
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.fit.SceneWindow;

/**
 * Carries all filaments of a movie from frame to frame, in one direction of time. In each
 * frame every filament starts from the cheapest of a few predictions (where it was, where it
 * was heading, slid along its own track), with all others drawn; then all are fitted in turn
 * until none moves, first nearly as predicted, then loosely. The length stays.
 */
final class SceneTracker {

	/** A glider may be faster or slower by so much (pixels), or so much if it was not seen before. */
	private static final double[] CHANGES = {0, -2, 2}, UNKNOWN = {-4, -2, 2, 4};

	private final LineTables line;
	private final SceneWeights weights;
	private final double mismatch;
	private final int[] wrong;
	private List<Chain> now;
	private List<Chain> before = List.of();

	/**
	 * @param line what a line looks like
	 * @param weights of the fit
	 * @param noise of a pixel in strands
	 * @param start the filaments in the frame from which to go on
	 */
	SceneTracker(final LineTables line, final SceneWeights weights, final double noise,
		final List<Chain> start) {
		this.line = line;
		mismatch = Math.max(SceneTuning.MISMATCH, SceneTuning.MISMATCH_NOISE * noise);
		this.weights = weights;
		now = start;
		wrong = new int[start.size()];
	}

	/**
	 * Goes on from two frames.
	 *
	 * @param before the filaments in the frame before that
	 * @param now the filaments in the frame from which to go on
	 */
	SceneTracker(final LineTables line, final SceneWeights weights, final double noise,
		final List<Chain> before, final List<Chain> now) {
		this(line, weights, noise, now);
		this.before = before;
	}

	/** Goes on to the next frame and gives the filaments there, in the order of the start. */
	List<Chain> step(final FrameView frame) {
		return step(frame, List.of());
	}

	/**
	 * The same beside others.
	 *
	 * @param others what else is in that frame; it stays as it is
	 */
	List<Chain> step(final FrameView frame, final List<Chain> others) {
		final int n = now.size();
		final List<List<Chain>> predictions = new ArrayList<>();
		final List<Chain> first = new ArrayList<>();
		for (int k = 0; k < now.size(); k++) {
			final List<Chain> p = predictions(k);
			predictions.add(p);
			first.add(p.get(Math.min(2, p.size() - 1)));
		}
		first.addAll(others);
		final Scene scene = new Scene(frame.light(), line, first);
		choose(scene, predictions);
		final List<Chain> expected = scene.chains();
		final double[] moved = new double[n];
		fit(scene, expected, moved, 0);
		final List<Chain> fitted = scene.chains();
		final boolean[] worthIt = worthMending(scene);
		final TipRepair tips = new TipRepair(scene, weights.tracked(), mismatch);
		for (int k = 0; k < n; k++)
			if (worthIt[k])
				tips.mend(k);
		new TailSwap(scene, weights.tracked(), expected, mismatch).mend(worthIt);
		boolean mended = false;
		for (int k = 0; k < n; k++)
			if (scene.chain(k) != fitted.get(k)) {
				moved[k] = Double.POSITIVE_INFINITY;
				mended = true;
			}
		fit(scene, mended ? scene.chains() : expected, moved, 2);
		before = now;
		now = List.copyOf(scene.chains().subList(0, n));
		return now;
	}

	/** What has been wrong for long is not mended in every frame. */
	private boolean[] worthMending(final Scene scene) {
		final boolean[] worthIt = new boolean[wrong.length];
		for (int k = 0; k < wrong.length; k++) {
			wrong[k] = scene.isOff(scene.chain(k), mismatch) ? wrong[k] + 1 : 0;
			worthIt[k] = wrong[k] <= SceneTuning.PATIENCE
				|| wrong[k] % SceneTuning.SELDOM_MENDED == 0;
		}
		return worthIt;
	}

	private List<Chain> predictions(final int k) {
		final Chain here = now.get(k);
		final List<Chain> all = new ArrayList<>(List.of(here));
		if (before.isEmpty()) {
			for (final double by : UNKNOWN)
				all.add(here.slid(by));
		} else {
			all.add(here.continued(before.get(k)));
			final double speed = before.get(k).slide(here);
			for (final double by : CHANGES)
				all.add(here.slid(speed + by));
		}
		return all;
	}

	/**
	 * The cheapest prediction of each, with the others drawn: twice, where one that is near was
	 * given another one meanwhile.
	 */
	private void choose(final Scene scene, final List<List<Chain>> predictions) {
		final boolean[] open = new boolean[predictions.size()];
		Arrays.fill(open, true);
		for (int round = 0; round < 2; round++)
			for (int k = 0; k < open.length; k++)
				if (open[k]) {
					open[k] = false;
					final Chain before = scene.chain(k);
					final Chain best = cheapest(scene, k, predictions.get(k));
					if (best != before) {
						open(scene, k, open);
						scene.put(k, best);
						open(scene, k, open);
					} else
						scene.put(k, best);
				}
	}

	/** The cheapest of some predictions; the chain is not drawn any more. */
	private Chain cheapest(final Scene scene, final int k, final List<Chain> predictions) {
		scene.take(k);
		final SceneWindow window = scene.window(predictions);
		Chain best = predictions.get(0);
		double lowest = Double.POSITIVE_INFINITY;
		for (final Chain p : predictions) {
			final double energy = window.price(p, weights.tracked()).energy();
			if (energy < lowest) {
				lowest = energy;
				best = p;
			}
		}
		return best;
	}

	/** What is near to a chain is open again. */
	private static void open(final Scene scene, final int k, final boolean[] open) {
		for (int other = 0; other < open.length; other++)
			open[other] |= other != k && scene.mayTouch(k, other);
	}

	/** Two sweeps; from the third on only chains near to what has moved. */
	private void fit(final Scene scene, final List<Chain> expected, final double[] moved,
		final int from) {
		for (int s = from; s < from + 2; s++)
			for (int k = 0; k < moved.length; k++)
				if (s < 2 || isRestless(scene, k, moved)) {
					final Chain start = scene.chain(k);
					scene.take(k);
					final Fit fit = scene.window(List.of(start)).fit(start,
						Optional.of(expected.get(k)),
						s == 0 ? weights.predicted() : weights.tracked());
					scene.put(k, fit.chain());
					moved[k] = start.distance(fit.chain());
				}
	}

	private static boolean isRestless(final Scene scene, final int k, final double[] moved) {
		for (int other = 0; other < moved.length; other++)
			if (moved[other] > SceneTuning.SWEEP_STILL && (other == k || scene.mayTouch(k, other)))
				return true;
		return false;
	}
}
