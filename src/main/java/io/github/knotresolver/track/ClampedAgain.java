
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings.LengthModel;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SceneSettler.Settled;

/**
 * A clamped filament that winds up is followed best by what is made for it ({@link
 * FitResolver}: the clamp, trails that use a segment twice, several hypotheses). It is given
 * the movie without the light of the other filaments.
 */
final class ClampedAgain {

	private final SceneLine line;
	private final Workers workers;
	private final Progress progress;

	ClampedAgain(final SceneLine line, final Workers workers, final Progress progress) {
		this.line = line;
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * Follows a filament again.
	 *
	 * @param pass all filaments
	 * @param k which one; -1 for one that is not among them
	 * @param clamp where it is held
	 * @return its chains in all frames, as long as it is in each; empty if it is not found
	 */
	Optional<Settled> follow(final ScenePass pass, final int k, final Point clamp) {
		return follow(alone(pass, k), clamp);
	}

	/** Follows the filament that is held somewhere besides some that are known. */
	Optional<Settled> followBeside(final ScenePass pass) {
		final List<FrameView> frames = alone(pass, -1);
		return new FixedEndFinder(frames, progress).find().flatMap(end -> follow(frames, end));
	}

	private Optional<Settled> follow(final List<FrameView> frames, final Point clamp) {
		return new FitResolver(TrailCandidates.DEFAULT, Set.of(line.tables().model().kind()),
			LengthModel.AUTO, workers, progress).besideOthers()
			.learn(frames, clamp, OptionalDouble.empty())
			.map(s -> s.solve(List.of(), workers, progress)).flatMap(ClampedAgain::settled);
	}

	/** The frames with the light of one filament only. */
	List<FrameView> alone(final ScenePass pass, final int k) {
		return workers.map("Taking the other filaments' light off", progress, line.frames().size(),
			t -> without(pass, k, t));
	}

	private FrameView without(final ScenePass pass, final int k, final int t) {
		final FrameView frame = line.frames().get(t);
		final List<Chain> others = new ArrayList<>(pass.chains().get(t));
		if (k >= 0)
			others.remove(k);
		return SceneRemainder.of(frame, line.tables(), others);
	}

	/** A frame without a contour has that of the nearest one before, or after. */
	private static Optional<Settled> settled(final Track found) {
		final int links = Chain.linksInScene(found.length());
		final List<Chain> chains = new ArrayList<>();
		final double[] gap = new double[found.frames().size()];
		Polyline last = found.frames().stream().map(Observation::contour).flatMap(Optional::stream)
			.findFirst().orElse(null);
		if (last == null)
			return Optional.empty();
		for (int t = 0; t < gap.length; t++) {
			final Observation o = found.frames().get(t);
			last = o.contour().orElse(last);
			gap[t] = o.contour().isPresent() ? SceneConfidence.gapOf(o.confidence()) : 0;
			chains.add(Chain.along(last, links, last.length()));
		}
		return Optional.of(new Settled(chains, gap, found.lengthError()));
	}
}
