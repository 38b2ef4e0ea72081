
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
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
		final int n = pass.chains().size();
		final List<Chain> chains = new ArrayList<>(Collections.nCopies(n, null));
		final double[] gap = new double[n];
		Arrays.fill(gap, Double.POSITIVE_INFINITY);
		for (int t = run[0]; t < run[1]; t++)
			chains.set(t, supple(pass.chains().get(t).get(k)));
		pursue(pass, k, new int[]{run[1] - SceneTuning.AGAIN_BACK, 1}, chains, gap);
		pursue(pass, k, new int[]{run[0] + SceneTuning.AGAIN_BACK - 1, -1}, chains, gap);
		return Optional.of(new Settled(chains, gap, Double.NaN));
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
	private void pursue(final ScenePass pass, final int k, final int[] way,
		final List<Chain> chains, final double[] gap) {
		final int start = way[0], step = way[1], n = chains.size();
		if (start + step < 0 || start + step >= n)
			return;
		final Pursuit pursuit = new Pursuit(line, SceneWeights.SUPPLE, pass, k);
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
