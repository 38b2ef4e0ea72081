package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.IntFunction;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.progress.Progress;

/**
 * Carries the best few hypotheses through the movie in one direction of time: in
 * each frame every hypothesis is fitted from where it was and from where it was
 * heading, and the fits of the graph's proposals join in. What does not keep up
 * with the best falls away.
 */
final class Propagation {

	private final int width;
	private final MotionPrice motion;
	private final IntFunction<FilamentFitter> fitters;
	private final List<List<Fit>> proposals;
	private final Frames frames;
	private final Progress progress;

	/**
	 * @param width number of hypotheses to keep
	 * @param motion price of moving between frames
	 * @param fitters gives the fitter of a frame
	 * @param proposals fits of the graph's candidates, by frame
	 * @param frames what is known about them
	 * @param progress asked whether to stop
	 */
	Propagation(final int width, final MotionPrice motion,
		final IntFunction<FilamentFitter> fitters, final List<List<Fit>> proposals,
		final Frames frames, final Progress progress) {
		this.width = width;
		this.motion = motion;
		this.fitters = fitters;
		this.proposals = proposals;
		this.frames = frames;
		this.progress = progress;
	}

	/**
	 * What is known about the frames.
	 *
	 * @param course where the fixed end is and how long the filament is
	 * @param freeLength whether the length is fitted
	 */
	record Frames(FilamentCourse course, boolean freeLength) {

		/** A chain of one frame where and as long as it should be in another. */
		Chain carried(final Chain chain, final int from, final int to) {
			final Chain moved = course.anchor().carried(chain, from, to);
			return freeLength ? moved : moved.resized(course.length().nearest(to, moved.length()));
		}
	}

	/** A hypothesis: a fit, where it came from, and the price of the way here. */
	private record Hypothesis(Fit fit, Optional<Chain> before, double total) {
	}

	/**
	 * Walks through frames.
	 *
	 * @param order the frames' indices in the order of walking
	 * @return the fits that were made, for each frame of {@code order}
	 */
	List<List<Fit>> walk(final int[] order) {
		final List<List<Fit>> made = new ArrayList<>();
		List<Hypothesis> beam = List.of();
		int last = order.length == 0 ? 0 : order[0];
		for (final int frame : order) {
			progress.checkCancelled();
			progress.report("Following the filament", (double) made.size() / order.length);
			final List<Hypothesis> next = new ArrayList<>();
			beam = carried(beam, last, frame);
			last = frame;
			final List<Fit> fits = carried(frame, beam, next);
			for (final Fit proposal : proposals.get(frame))
				next.add(joined(proposal, beam));
			beam = best(next);
			made.add(fits);
		}
		return made;
	}

	/**
	 * Walks on from some fits of a frame until nothing comes up any more that is not known.
	 *
	 * @param from index of the frame
	 * @param step 1 forwards in time, -1 backwards
	 * @param fits the fits
	 * @param known the fits that are known already, by index of the frame
	 * @return what is new, by index of the frame
	 */
	SortedMap<Integer, List<Fit>> spread(final int from, final int step, final List<Fit> fits,
		final List<List<Fit>> known) {
		final SortedMap<Integer, List<Fit>> news = new TreeMap<>();
		List<Hypothesis> beam = best(new ArrayList<>(
			fits.stream().map(f -> new Hypothesis(f, Optional.empty(), f.energy())).toList()));
		for (int t = from + step; t >= 0 && t < known.size() && !beam.isEmpty(); t += step) {
			progress.checkCancelled();
			final List<Hypothesis> next = new ArrayList<>();
			carried(t, carried(beam, t - step, t), next);
			final List<Fit> old = known.get(t);
			next.removeIf(h -> isKnown(h.fit, old));
			beam = next.isEmpty() ? List.of() : best(next);
			if (!beam.isEmpty())
				news.put(t, beam.stream().map(Hypothesis::fit).toList());
		}
		return news;
	}

	/** Whether a fit is one that is known, or so much dearer that it will never be taken. */
	private static boolean isKnown(final Fit fit, final List<Fit> known) {
		return known.stream().anyMatch(k -> FitPool.isSame(k, fit))
			|| fit.energy() > TrackTuning.HOPELESS + cheapest(known);
	}

	/** The energy of the cheapest of some fits; infinite if there is none. */
	static double cheapest(final List<Fit> fits) {
		return fits.stream().mapToDouble(Fit::energy).min().orElse(Double.POSITIVE_INFINITY);
	}

	/** The hypotheses as they would be if the filament moved with its anchor only. */
	private List<Hypothesis> carried(final List<Hypothesis> beam, final int from, final int to) {
		return beam.stream()
			.map(h -> new Hypothesis(
				new Fit(frames.carried(h.fit.chain(), from, to), h.fit.light(), h.fit.energy(), 0),
				h.before.map(b -> frames.carried(b, from, to)), h.total))
			.toList();
	}

	private List<Fit> carried(final int frame, final List<Hypothesis> beam,
		final List<Hypothesis> next) {
		final FilamentFitter fitter = fitters.apply(frame);
		final WoundStarts wound = new WoundStarts(motion.usualMotion());
		final List<Fit> all = new ArrayList<>();
		double cheapest = cheapest(proposals.get(frame));
		for (final Hypothesis h : beam) {
			final List<Fit> fits = new ArrayList<>();
			final Chain here = h.fit.chain();
			final Optional<Chain> heading = h.before
				.map(b -> here.extrapolated(b, TrackTuning.INERTIA));
			final List<Chain> starts = new ArrayList<>(List.of(here));
			h.before.map(b -> here.extrapolated(b, 1))
				.filter(s -> s.distance(here) > TrackTuning.SLOW).ifPresent(starts::add);
			for (final Chain start : starts)
				fits.add(fitter.fit(start, Optional.of(heading.orElse(here)),
					cheapest + TrackTuning.HOPELESS));
			for (final Chain start : h == beam.get(0) ? wound.of(here, fitter) : List.<Chain>of())
				fits.add(fitter.fit(start, Optional.empty(), cheapest + TrackTuning.HOPELESS));
			cheapest = Math.min(cheapest, cheapest(fits));
			for (final Fit fit : fits)
				next.add(new Hypothesis(fit, Optional.of(here),
					h.total + fit.energy() + motion.between(here, fit.chain())));
			all.addAll(fits);
		}
		return all;
	}

	/** A proposal joins the way that leads to it most cheaply. */
	private Hypothesis joined(final Fit proposal, final List<Hypothesis> beam) {
		Hypothesis best = new Hypothesis(proposal, Optional.empty(),
			beam.isEmpty() ? proposal.energy() : Double.POSITIVE_INFINITY);
		for (final Hypothesis h : beam) {
			final double total = h.total + proposal.energy()
				+ motion.between(h.fit.chain(), proposal.chain());
			if (total < best.total)
				best = new Hypothesis(proposal, Optional.of(h.fit.chain()), total);
		}
		return best;
	}

	private List<Hypothesis> best(final List<Hypothesis> all) {
		all.sort(Comparator.comparingDouble(Hypothesis::total));
		final List<Hypothesis> kept = new ArrayList<>();
		final FitPool different = new FitPool();
		for (final Hypothesis h : all) {
			if (kept.size() == width || h.total > all.get(0).total + TrackTuning.HOPELESS)
				break;
			if (different.add(h.fit) == h.fit && different.fits().size() > kept.size())
				kept.add(h);
		}
		return kept;
	}
}
