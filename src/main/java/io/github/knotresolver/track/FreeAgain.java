
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.Pursuit.Course;
import io.github.knotresolver.track.SceneSettler.Settled;

/**
 * A free filament that is followed again from where it is seen clearly for longest, with several
 * hypotheses ({@link Pursuit}), as one that bends more than usual: so it is followed into and out
 * of a knot of its own.
 */
final class FreeAgain {

	private final SceneLine line;
	private final Workers workers;
	private final Progress progress;

	FreeAgain(final SceneLine line, final Workers workers, final Progress progress) {
		this.line = line;
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * Follows a filament again. Time O(frames).
	 *
	 * @param pass all filaments
	 * @param k which one
	 * @param clear for each frame whether the light around it is explained
	 * @return its chains in all frames; empty if it is never clear for long enough
	 */
	Optional<Settled> follow(final ScenePass pass, final int k, final boolean[] clear) {
		final int[] run = ScenePass.longestRun(clear);
		if (run[1] - run[0] < SceneTuning.AGAIN_CLEAR)
			return Optional.empty();
		final List<Priced> courses = new ArrayList<>();
		for (final boolean bendsOnce : new boolean[]{false, true})
			courses.add(course(pass, k, run, bendsOnce));
		courses.sort(Comparator.comparingDouble(Priced::sum));
		final Priced best = courses.get(0), other = courses.get(1);
		new BothWays(line, SceneWeights.SUPPLE, pass, k).settle(best.filament.chains(),
			other.filament.chains(), progress);
		return Optional.of(new Settled(best.filament.chains(), gap(best, other), Double.NaN));
	}

	/** A course, and what the movie leaves unexplained with it, frame by frame. */
	private record Priced(Settled filament, double[] left) {
		double sum() {
			return Arrays.stream(left).sum();
		}
	}

	private Priced course(final ScenePass pass, final int k, final int[] run,
		final boolean bendsOnce) {
		final int n = pass.chains().size();
		final List<Chain> chains = new ArrayList<>(Collections.nCopies(n, null));
		final double[] gap = new double[n];
		Arrays.fill(gap, Double.POSITIVE_INFINITY);
		for (int t = run[0]; t < run[1]; t++)
			chains.set(t, supple(pass.chains().get(t).get(k)));
		final Pursuit pursuit = new Pursuit(line, SceneWeights.SUPPLE, pass, k, bendsOnce);
		pursue(pursuit, new int[]{run[1] - SceneTuning.AGAIN_BACK, 1}, chains, gap);
		pursue(pursuit, new int[]{run[0] + SceneTuning.AGAIN_BACK - 1, -1}, chains, gap);
		new BothWays(line, SceneWeights.SUPPLE, pass, k).settle(chains, chains, progress);
		return new Priced(new Settled(chains, gap, Double.NaN), workers.map(n, t -> {
			final List<Chain> all = new ArrayList<>(pass.chains().get(t));
			all.set(k, chains.get(t));
			return line.left(t, all);
		}).stream().mapToDouble(Double::doubleValue).toArray());
	}

	/** Where two courses differ visibly, one is as likely as the other is dearer on that stretch. */
	private static double[] gap(final Priced best, final Priced other) {
		final double[] gap = best.filament.gap().clone();
		final int n = gap.length;
		double dearer = 0;
		for (int t = 0, from = 0; t <= n; t++)
			if (t < n && best.filament.chains().get(t)
				.farthest(other.filament.chains().get(t)) > SceneTuning.VISIBLY_FAR)
				dearer += other.left[t] - best.left[t];
			else {
				final double likely = 1 / (1 + Math.exp(-dearer / SceneTuning.SCENE_GAP));
				for (int s = from; s < t; s++)
					gap[s] = Math.min(gap[s], SceneConfidence.gapOf(likely));
				from = t + 1;
				dearer = 0;
			}
		return gap;
	}

	private static Chain supple(final Chain chain) {
		return chain.divided(
			Math.max(chain.links(), (int) Math.rint(chain.length() / SceneTuning.AGAIN_LINK)));
	}

	/**
	 * Goes on from a frame in one direction of time.
	 *
	 * @param way the frame, and 1 or -1
	 */
	private void pursue(final Pursuit pursuit, final int[] way, final List<Chain> chains,
		final double[] gap) {
		final int start = way[0], step = way[1], n = chains.size();
		if (start + step < 0 || start + step >= n)
			return;
		List<Course> courses = List
			.of(new Course(chains.get(start), 0, new Course(chains.get(start - step), 0, null)));
		int end = start;
		for (int t = start + step; t >= 0 && t < n; t += step) {
			progress.checkCancelled();
			courses = pursuit.next(courses, t, workers);
			end = t;
		}
		final Course best = courses.get(0);
		Course at = best;
		for (int t = end; t != start; t -= step) {
			chains.set(t, at.chain());
			at = at.before();
		}
		for (final Course other : courses) {
			Course a = best, b = other;
			for (int t = end; t != start; t -= step) {
				if (a.chain().farthest(b.chain()) > SceneTuning.VISIBLY_FAR)
					gap[t] = Math.min(gap[t], other.sum() - best.sum());
				a = a.before();
				b = b.before();
			}
		}
		for (int t = end; t != start; t -= step)
			gap[t] = Math.min(gap[t], SceneTuning.PURSUIT_MARGIN);
	}
}
