
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
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
		final List<Chain> known = pass.filament(k).stream().map(FreeAgain::supple).toList();
		final boolean[] sure = new boolean[clear.length];
		for (int t = 0; t < sure.length; t++)
			sure[t] = clear[t] && known.get(t).links() == known.get(run[0]).links();
		for (final boolean bendsOnce : new boolean[]{false, true})
			courses.add(course(pass, k, known, sure, run, bendsOnce));
		courses.sort(Comparator.comparingDouble(Priced::sum));
		final Priced best = courses.get(0), other = courses.get(1);
		final BitSet all = new BitSet();
		all.set(0, clear.length);
		new BothWays(line, SceneWeights.SUPPLE, pass, k).settle(best.filament.chains(),
			other.filament.chains(), all, progress);
		return Optional.of(new Settled(best.filament.chains(), gap(best, other), Double.NaN));
	}

	/** Where two courses are not the same. */
	private static BitSet others(final List<Chain> a, final List<Chain> b) {
		final BitSet others = new BitSet();
		for (int t = 0; t < a.size(); t++)
			others.set(t, a.get(t) != b.get(t));
		return others;
	}

	/** A course, and what the movie leaves unexplained with it, frame by frame. */
	private record Priced(Settled filament, double[] left) {
		double sum() {
			return Arrays.stream(left).sum();
		}
	}

	private Priced course(final ScenePass pass, final int k, final List<Chain> known,
		final boolean[] clear, final int[] run, final boolean bendsOnce) {
		final int n = pass.chains().size();
		final List<Chain> chains = new ArrayList<>(Collections.nCopies(n, null));
		final double[] gap = new double[n];
		Arrays.fill(gap, Double.POSITIVE_INFINITY);
		for (int t = run[0]; t < run[1]; t++)
			chains.set(t, known.get(t));
		final Pursuit pursuit = new Pursuit(line, SceneWeights.SUPPLE, pass, k, bendsOnce);
		pursue(pursuit, new int[]{run[1] - SceneTuning.AGAIN_BACK, 1}, known, clear, chains, gap);
		pursue(pursuit, new int[]{run[0] + SceneTuning.AGAIN_BACK - 1, -1}, known, clear, chains,
			gap);
		new BothWays(line, SceneWeights.SUPPLE, pass, k).settle(chains, chains,
			others(known, chains), progress);
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
	 * Goes on from a frame in one direction of time: through what is unclear, until the filament is
	 * back where it was followed before, and on from the next frame that is unclear.
	 *
	 * @param way the frame, and 1 or -1
	 * @param known the filament as it was followed before, in all frames
	 * @param clear for each frame whether the light around it is explained
	 * @param chains of all frames; changed in place
	 */
	private void pursue(final Pursuit pursuit, final int[] way, final List<Chain> known,
		final boolean[] clear, final List<Chain> chains, final double[] gap) {
		final int step = way[1], n = known.size();
		int start = way[0];
		while (start + step >= 0 && start + step < n) {
			final int end = pursueUntilKnown(pursuit, start, step, known, clear, chains, gap);
			int next = end;
			for (int t = end + step; t >= 0 && t < n && clear[t]; t += step) {
				chains.set(t, known.get(t));
				next = t;
			}
			final boolean isLast = next + step < 0 || next + step >= n;
			start = isLast ? next : next - (SceneTuning.AGAIN_BACK - 1) * step;
		}
	}

	/** Goes on from a frame until the filament is where it was known before; that frame. */
	private int pursueUntilKnown(final Pursuit pursuit, final int start, final int step,
		final List<Chain> known, final boolean[] clear, final List<Chain> chains,
		final double[] gap) {
		List<Course> courses = List
			.of(new Course(chains.get(start), 0, new Course(chains.get(start - step), 0, null)));
		int end = start;
		for (int t = start + step; t >= 0 && t < known.size()
			&& !isKnown(courses.get(0), start, end, step, known, clear); t += step) {
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
		return end;
	}

	/**
	 * Whether a course was where the filament is known, and all was clear, for some frames, and stays
	 * so for some.
	 */
	private static boolean isKnown(final Course course, final int start, final int end,
		final int step, final List<Chain> known, final boolean[] clear) {
		if (Math.abs(end - start) < 2 * SceneTuning.AGAIN_BACK)
			return false;
		for (int i = 1; i <= SceneTuning.AGAIN_CLEAR; i++) {
			final int t = end + i * step;
			if (t >= 0 && t < clear.length && !clear[t])
				return false;
		}
		Course at = course;
		for (int i = 0; i < SceneTuning.AGAIN_BACK; i++) {
			final int t = end - i * step;
			if (!clear[t] || at.chain().farthest(known.get(t)) >= SceneTuning.PURSUIT_SAME)
				return false;
			at = at.before();
		}
		return true;
	}
}
