package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.SceneWindow;
import io.github.knotresolver.progress.Progress;

/**
 * A glider that was followed in one direction of time, made better by what comes later: each
 * frame is tried as the frames before and after it say, a little back or farther along the
 * track, and keeps what is cheapest in light, bending and motion from the one and to the other.
 * So what is hidden in one frame, and seen in the next, is right in both.
 */
final class BothWays {

	private final SceneLine line;
	private final FitSettings settings;
	private final ScenePass pass;
	private final int filament;

	/**
	 * @param line what a line looks like, and the frames
	 * @param weights of the fit
	 * @param pass all filaments
	 * @param filament the one that was followed
	 */
	BothWays(final SceneLine line, final SceneWeights weights, final ScenePass pass,
		final int filament) {
		this.line = line;
		settings = weights.tracked();
		this.pass = pass;
		this.filament = filament;
	}

	/**
	 * Sweeps over the frames that are open, there and back, until nothing changes; O(frames) each.
	 * Where one changes, those beside it are open, too.
	 *
	 * @param chains the filament in all frames, with as many links in each; changed in place
	 * @param other another course of it, which is tried as well; the same if there is none
	 * @param open the frames to begin with; those that are left, if any, when it stops
	 * @param progress asked whether to stop
	 */
	void settle(final List<Chain> chains, final List<Chain> other, final BitSet open,
		final Progress progress) {
		final int n = chains.size();
		for (int i = 0; i < 2 * n * SceneTuning.BOTH_ROUNDS && !open.isEmpty(); i++) {
			final int at = i % (2 * n), t = at < n ? n - 1 - at : at - n;
			if (!open.get(t))
				continue;
			progress.checkCancelled();
			open.clear(t);
			if (improve(chains, other, t))
				open.set(Math.max(0, t - 1), Math.min(n, t + 2));
		}
	}

	private boolean improve(final List<Chain> chains, final List<Chain> other, final int t) {
		final Chain here = chains.get(t);
		final List<List<Chain>> predictions = new ArrayList<>();
		for (int beside = t - 1; beside <= t + 1; beside += 2)
			if (beside >= 0 && beside < chains.size())
				predictions.add(predictions(here, chains.get(beside)));
		final List<Chain> all = new ArrayList<>(List.of(here, other.get(t)));
		predictions.forEach(all::addAll);
		final List<Chain> others = new ArrayList<>(pass.chains().get(t));
		others.remove(filament);
		final SceneWindow window = line.scene(t, others).window(all);
		final List<Fit> tried = new ArrayList<>(List.of(window.price(other.get(t), settings)));
		for (final List<Chain> some : predictions) {
			final Chain expected = window.cheapest(some, settings);
			if (expected.farthest(here) >= SceneTuning.PURSUIT_SAME)
				tried.add(window.fit(expected, Optional.of(expected), settings));
		}
		double lowest = price(chains, t, window.price(here, settings));
		for (final Fit fit : tried) {
			final double price = price(chains, t, fit);
			if (price < lowest - SceneTuning.BOTH_BETTER) {
				lowest = price;
				chains.set(t, fit.chain());
			}
		}
		return chains.get(t) != here;
	}

	/** Where the filament would be as a frame beside it says. */
	private static List<Chain> predictions(final Chain here, final Chain beside) {
		final double by = beside.slide(here);
		final List<Chain> all = new ArrayList<>(List.of(beside));
		for (final double change : Pursuit.CHANGES)
			all.add(beside.slid(by + change));
		all.addAll(HeldEnd.shapes(beside, by));
		return all;
	}

	private double price(final List<Chain> chains, final int t, final Fit fit) {
		double price = fit.light() + SceneTuning.BENT_ONCE * (fit.energy() - fit.light());
		if (t > 0)
			price += off(chains.get(t - 1), fit.chain());
		if (t + 1 < chains.size())
			price += off(fit.chain(), chains.get(t + 1));
		return price;
	}

	/** How far a filament left its track, where both lie on it and no end is held. */
	private double off(final Chain before, final Chain after) {
		final double by = before.slide(after);
		final Chain slid = before.slid(by);
		final int out = (int) Math.ceil(Math.abs(by) / before.linkLength()), n = before.links();
		final int piece = HeldEnd.piece(before);
		final int from = HeldEnd.isHeld(before.start(), after.start(), by)
			? piece
			: by < 0 ? out : 0;
		final int to = HeldEnd.isHeld(before.tip(), after.tip(), by)
			? n - piece
			: by < 0 ? n : n - out;
		return settings.memory() * before.linkLength() * after.squaredTurn(slid, from, to);
	}
}
