package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateGenerator;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.StartMaker;
import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;

/** Graph proposes, fit decides, trellis settles. */
public final class FitTracker {

	static int SIGHT = 14, TRY = 12, FITS = 4, WIDTH = 3;
	static double PER_PIXEL = 1.0;

	private final List<FrameView> frames;
	private final CandidateGenerator generator;
	private final Progress progress;

	public FitTracker(final List<FrameView> frames, final CandidateGenerator generator,
		final Progress progress) {
		this.frames = frames;
		this.generator = generator;
		this.progress = progress;
	}

	public record Tracked(FilamentEstimate estimate, List<Fit> fits, double[] gap,
		List<List<Fit>> pools) {
	}

	private record Seen(FrameView frame, Polyline contour, double price) {
	}

	public Tracked track(final Point clamp) {
		final OptionalDouble unknown = OptionalDouble.empty();
		final List<CandidateSet> first = IntStream.range(0, frames.size()).parallel()
			.mapToObj(t -> generator
				.generate(CandidateQuery.of(frames.get(t).graph(), clamp, unknown), progress))
			.toList();
		final FilamentEstimate estimate = FilamentEstimator.estimate(sightings(first), progress);
		final int links = FilamentEstimator.links(estimate.length());
		final OptionalDouble known = OptionalDouble.of(estimate.length());
		final List<NormalizedFrame> light = frames.stream()
			.map(f -> f.light().rescaled(0, estimate.amplitude())).toList();
		final IntFunction<FilamentFitter> fitters = t -> new FilamentFitter(light.get(t),
			estimate.model(), links, Optional.of(estimate.fixedEnd()), FitSettings.DEFAULT);
		final List<List<Fit>> proposals = IntStream.range(0, frames.size()).parallel()
			.mapToObj(t -> proposals(fitters.apply(t),
				generator.generate(CandidateQuery.of(frames.get(t).graph(), clamp, known), progress)
					.candidates(),
				estimate, links))
			.toList();
		final MotionPrice motion = new MotionPrice(PER_PIXEL);
		final int n = frames.size();
		final List<List<List<Fit>>> passes = List
			.of(IntStream.range(0, n).toArray(),
				IntStream.range(0, n).map(i -> n - 1 - i).toArray())
			.parallelStream()
			.map(order -> new Propagation(WIDTH, motion, fitters, proposals, progress).walk(order))
			.toList();
		final List<List<Fit>> pools = new ArrayList<>();
		for (int t = 0; t < n; t++) {
			final FitPool pool = new FitPool();
			proposals.get(t).forEach(pool::add);
			passes.get(0).get(t).forEach(pool::add);
			passes.get(1).get(n - 1 - t).forEach(pool::add);
			pools.add(pool.fits());
		}
		return solve(estimate, pools, motion);
	}

	private Tracked solve(final FilamentEstimate estimate, final List<List<Fit>> pools,
		final MotionPrice motion) {
		final int n = pools.size();
		double[] best = pools.get(0).stream().mapToDouble(Fit::energy).toArray();
		final List<int[]> back = new ArrayList<>();
		back.add(new int[best.length]);
		for (int t = 1; t < n; t++) {
			final List<Fit> a = pools.get(t - 1), b = pools.get(t);
			final double[] next = new double[b.size()];
			final int[] from = new int[b.size()];
			for (int j = 0; j < b.size(); j++) {
				next[j] = Double.POSITIVE_INFINITY;
				for (int i = 0; i < a.size(); i++) {
					final double c = best[i] + motion.between(a.get(i).chain(), b.get(j).chain());
					if (c < next[j]) {
						next[j] = c;
						from[j] = i;
					}
				}
				next[j] += b.get(j).energy();
			}
			best = next;
			back.add(from);
		}
		int k = 0;
		for (int i = 0; i < best.length; i++)
			if (best[i] < best[k])
				k = i;
		final Fit[] fits = new Fit[n];
		for (int t = n - 1; t >= 0; t--) {
			fits[t] = pools.get(t).get(k);
			k = back.get(t)[k];
		}
		return new Tracked(estimate, List.of(fits), new double[n], pools);
	}

	private static List<Fit> proposals(final FilamentFitter fitter,
		final List<Candidate> candidates, final FilamentEstimate estimate, final int links) {
		final List<Fit> rough = new ArrayList<>();
		for (final Candidate c : candidates.subList(0, Math.min(TRY, candidates.size())))
			rough.add(fitter.price(StartMaker.start(ContourBuilder.smooth(c), estimate.fixedEnd(),
				links, estimate.length())));
		rough.sort(Comparator.comparingDouble(Fit::energy));
		final FitPool pool = new FitPool();
		for (final Fit r : rough.subList(0, Math.min(FITS, rough.size())))
			pool.add(fitter.fit(r.chain(), Optional.empty()));
		return pool.fits();
	}

	private List<FilamentEstimator.Sighting> sightings(final List<CandidateSet> sets) {
		final List<Seen> seen = new ArrayList<>();
		for (int t = 0; t < sets.size(); t++) {
			if (sets.get(t).candidates().isEmpty())
				continue;
			final Candidate c = sets.get(t).candidates().get(0);
			final Polyline contour = ContourBuilder.smooth(c);
			if (c.price().overlap() == 0 && contour.length() > 15
				&& Crossings.of(contour).isEmpty())
				seen.add(new Seen(frames.get(t), contour, c.price().total()));
		}
		final List<Seen> simple = seen.stream().filter(s -> s.frame.graph().isUnbranched())
			.toList();
		final List<Seen> from = simple.size() >= 3 ? simple : seen;
		final double[] lengths = from.stream().mapToDouble(s -> s.contour.length()).sorted()
			.toArray();
		final double middle = lengths[(int) (lengths.length * 0.8)];
		final List<Seen> good = from.stream()
			.filter(s -> Math.abs(s.contour.length() / middle - 1) < .06)
			.sorted(Comparator.comparingDouble(Seen::price)).toList();
		return good.subList(0, Math.min(SIGHT, good.size())).stream()
			.map(s -> new FilamentEstimator.Sighting(s.frame.light(), s.contour)).toList();
	}
}
