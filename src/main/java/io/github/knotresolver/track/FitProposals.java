package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.StartMaker;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * Turns the graph's candidates of a frame into fits: the cheapest are drawn and compared
 * with the picture as they are, and those that explain it best are fitted.
 *
 * @param frame the frame
 * @param estimate what is known about the filament in this frame
 * @param links number of links of all chains
 * @param freeLength whether a start has the contour's own length
 */
record FitProposals(FrameView frame, FilamentEstimate estimate, int links, boolean freeLength) {

	/** Number of links of chains that hardly bend, before they may: half as many stand for these. */
	static int stiffLinks(final int links) {
		return (links + 1) / 2;
	}

	List<Fit> of(final CandidateSet set, final FilamentFitter fitter, final FilamentFitter stiff) {
		final List<Fit> rough = new ArrayList<>();
		for (final Candidate c : set.candidates().stream().limit(TrackTuning.DRAWN).toList())
			rough.add(fitter.price(start(ContourBuilder.smooth(c), estimate.fixedEnd())));
		return fitted(rough.stream().sorted(Comparator.comparingDouble(Fit::energy))
			.limit(TrackTuning.FITTED).map(Fit::chain), fitter, stiff);
	}

	/** All candidates that are as asked for, fitted. */
	List<Fit> of(final CandidateSet set, final FilamentFitter fitter, final FilamentFitter stiff,
		final Predicate<Polyline> wanted) {
		return fitted(set.candidates().stream().map(ContourBuilder::smooth).filter(wanted)
			.limit(TrackTuning.DRAWN).map(c -> start(c, estimate.fixedEnd())), fitter, stiff);
	}

	/** A start, fitted while it hardly bends, with as many links as it has. */
	static Chain bent(final Chain start, final FilamentFitter stiff) {
		return stiff.fit(start.divided(stiff.links()), Optional.empty()).chain()
			.divided(start.links());
	}

	/** Starts that become the same while they hardly bend are fitted once. */
	private static List<Fit> fitted(final Stream<Chain> starts, final FilamentFitter fitter,
		final FilamentFitter stiff) {
		final FitPool pool = new FitPool();
		final List<Chain> begun = new ArrayList<>();
		double cheapest = Double.POSITIVE_INFINITY;
		for (final Chain start : starts.toList()) {
			final Chain bent = bent(start, stiff);
			if (begun.stream().anyMatch(b -> b.distance(bent) < TrackTuning.SAME_START))
				continue;
			begun.add(bent);
			final Fit fit = fitter.fit(bent, Optional.empty(), cheapest + TrackTuning.HOPELESS);
			cheapest = Math.min(cheapest, fit.energy());
			pool.add(fit);
		}
		return pool.fits();
	}

	/** The only fit of a frame for which a contour was given. */
	List<Fit> of(final Polyline given, final FilamentFitter fitter) {
		return List.of(fitter.fit(start(given), Optional.empty()));
	}

	/** The chain along a contour from its first point. */
	Chain start(final Polyline contour) {
		return start(contour, contour.first());
	}

	private Chain start(final Polyline contour, final Point from) {
		final double length = freeLength ? contour.length() : estimate.length();
		return freeLength || !FreeEnds.atBorder(frame, contour.last())
			? StartMaker.start(contour, from, links, length)
			: StartMaker.leaving(contour, from, links, length);
	}
}
