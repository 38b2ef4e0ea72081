
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.model.Settings.AnchorChoice;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SceneSettler.Settled;

/**
 * What tracking alone leaves unclear is tried again with what is made for one clamped
 * filament: a clamped one ({@link ClampedAgain}), or a free one that crosses itself ({@link
 * FreeAgain}); then, if that leaves light unexplained, all that moves as one filament beside what
 * lies still. Kept where the movie becomes cheaper. Left alone where hardly anything is clear.
 */
final class SceneRefinement {

	private final SceneLine line;
	private final SceneWeights weights;
	private final Workers workers;
	private final Progress progress;
	private final ClampedAgain again;

	SceneRefinement(final SceneLine line, final SceneWeights weights, final Workers workers,
		final Progress progress) {
		this.line = line;
		this.weights = weights;
		this.workers = workers;
		this.progress = progress;
		again = new ClampedAgain(line, workers, progress);
	}

	List<Settled> refine(final List<Settled> found) {
		final boolean[][] clear = clear(found);
		if (isHopeless(found, clear))
			return found;
		List<Settled> filaments = wholes(found);
		boolean[] unclear = unclear(filaments == found ? clear : clear(filaments));
		for (int round = 0; round < SceneTuning.REFINE_ROUNDS; round++)
			for (int k = 0; k < filaments.size(); k++) {
				progress.checkCancelled();
				if (!unclear[k])
					continue;
				final List<Settled> next = followedAgain(filaments, k, round == 0);
				if (next != filaments)
					unclear = unclear(clear(next));
				filaments = next;
			}
		for (final boolean u : unclear)
			if (u)
				return besideWhatLiesStill(filaments);
		return filaments;
	}

	/** Where hardly any light is explained, following one filament again explains no more of it. */
	private static boolean isHopeless(final List<Settled> found, final boolean[][] clear) {
		double all = 0, explained = 0;
		for (int k = 0; k < clear.length; k++)
			for (int t = 0; t < clear[k].length; t++) {
				final double length = found.get(k).chains().get(t).length();
				all += length;
				explained += clear[k][t] ? length : 0;
			}
		return explained < SceneTuning.HOPELESS_CLEAR * all;
	}

	/** Filaments that always touch may be one clamped filament that lies on itself. */
	private List<Settled> wholes(final List<Settled> found) {
		if (found.stream().noneMatch(SceneRefinement::isClamped))
			return found;
		List<Settled> filaments = found;
		for (int k = 0; k < filaments.size(); k++) {
			progress.checkCancelled();
			final List<Integer> touching = ScenePass.of(filaments).touching(k);
			final List<Settled> group = touching.stream().map(filaments::get).toList();
			final List<Settled> others = new ArrayList<>(filaments);
			others.removeAll(group);
			if (touching.get(0) < k || group.size() < 2 || group.size() > SceneTuning.MOST_PIECES
				|| others.isEmpty() || group.stream().noneMatch(SceneRefinement::isClamped))
				continue;
			final Optional<Settled> whole = again.followBeside(ScenePass.of(others))
				.filter(SceneRefinement::isCredible);
			if (whole.isPresent()) {
				others.add(whole.get());
				filaments = cheaper(filaments, others, others.size() - 1, whole.get());
			}
		}
		return filaments;
	}

	private static boolean isClamped(final Settled filament) {
		return FilamentEnds.of(filament.chains(), AnchorChoice.AUTO).clamped();
	}

	/** What was put together from several explains their light, but is doubtful as a whole. */
	private static boolean isCredible(final Settled filament) {
		return Arrays.stream(filament.gap())
			.filter(g -> g >= SceneConfidence.gapOf(SceneTuning.LENGTH_DOUBT))
			.count() >= SceneTuning.CREDIBLE * filament.gap().length;
	}

	private boolean[][] clear(final List<Settled> filaments) {
		return ScenePass.of(filaments).clear(line, workers);
	}

	/** For each filament whether the light around it is not explained in some frames. */
	private static boolean[] unclear(final boolean[][] clear) {
		final boolean[] unclear = new boolean[clear.length];
		for (int k = 0; k < unclear.length; k++) {
			int frames = 0;
			for (final boolean c : clear[k])
				frames += c ? 0 : 1;
			unclear[k] = frames > SceneTuning.SOME_UNCLEAR * clear[k].length;
		}
		return unclear;
	}

	private List<Settled> followedAgain(final List<Settled> filaments, final int k,
		final boolean first) {
		final ScenePass pass = ScenePass.of(filaments);
		final FilamentEnds ends = FilamentEnds.of(pass.filament(k), AnchorChoice.AUTO);
		if (!ends.clamped())
			return first ? freeAgain(filaments, pass, k) : filaments;
		return again.follow(pass, k, FilamentEnds.place(pass.filament(k), ends.reversed()))
			.map(s -> cheaper(filaments, filaments, k, s)).orElse(filaments);
	}

	/** A free filament that is unclear where no other one is: it crosses itself. */
	private List<Settled> freeAgain(final List<Settled> filaments, final ScenePass pass,
		final int k) {
		final boolean[] clear = pass.clear(line, workers)[k];
		int byItself = 0;
		for (int t = 0; t < clear.length; t++)
			byItself += !clear[t] && pass.isAlone(k, t, line) ? 1 : 0;
		return byItself <= SceneTuning.SOME_UNCLEAR * clear.length
			? filaments
			: new FreeAgain(line, workers, progress).follow(pass, k, clear)
				.map(s -> cheaper(filaments, filaments, k, s)).orElse(filaments);
	}

	/** One clamped filament instead of all that moves. */
	private List<Settled> besideWhatLiesStill(final List<Settled> filaments) {
		final ScenePass pass = ScenePass.of(filaments);
		final List<Settled> still = new ArrayList<>();
		for (int k = 0; k < filaments.size(); k++)
			if (pass.motion(k) < SceneTuning.REFINE_STILL)
				still.add(filaments.get(k));
		if (still.isEmpty() || still.size() == filaments.size()
			|| filaments.size() - still.size() > SceneTuning.MOST_PIECES)
			return filaments;
		final Optional<Settled> moving = again.followBeside(ScenePass.of(still));
		if (moving.isEmpty())
			return filaments;
		still.add(moving.get());
		return cheaper(filaments, still, still.size() - 1, moving.get());
	}

	/** Filaments with another k-th one, the others fitted again; or as they were if cheaper. */
	private List<Settled> cheaper(final List<Settled> before, final List<Settled> after,
		final int k, final Settled better) {
		final List<Settled> replaced = new ArrayList<>(after);
		replaced.set(k, better);
		final ScenePass with = ScenePass.of(replaced).with(k, better.chains(), line, weights,
			workers);
		if (with.price(line, workers) >= ScenePass.of(before).price(line, workers))
			return before;
		for (int j = 0; j < replaced.size(); j++)
			if (j != k)
				replaced.set(j, new Settled(with.filament(j), replaced.get(j).gap(),
					replaced.get(j).lengthError()));
		return replaced;
	}
}
