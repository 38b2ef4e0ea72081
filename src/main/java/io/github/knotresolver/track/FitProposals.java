package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.StartMaker;
import io.github.knotresolver.geometry.Polyline;

/**
 * Turns the graph's candidates of a frame into fits: all of the cheapest are drawn
 * and compared with the picture as they are, and those that explain it best are
 * fitted.
 */
record FitProposals(FilamentEstimate estimate, int drawn, int fitted) {

	static FitProposals with(final FilamentEstimate estimate) {
		return new FitProposals(estimate, 12, 4);
	}

	List<Fit> of(final CandidateSet set, final FilamentFitter fitter) {
		final List<Fit> rough = new ArrayList<>();
		for (final Candidate c : set.candidates().stream().limit(drawn).toList())
			rough.add(fitter.price(StartMaker.start(ContourBuilder.smooth(c), estimate.fixedEnd(),
				FilamentEstimator.links(estimate.length()), estimate.length())));
		final FitPool pool = new FitPool();
		rough.stream().sorted(Comparator.comparingDouble(Fit::energy)).limit(fitted)
			.forEach(r -> pool.add(fitter.fit(r.chain(), Optional.empty())));
		return pool.fits();
	}

	/** The only fit of a frame for which the user gave a contour. */
	List<Fit> of(final Polyline given, final FilamentFitter fitter) {
		return List.of(fitter.fit(StartMaker.start(given, given.first(),
			FilamentEstimator.links(estimate.length()), estimate.length()), Optional.empty()));
	}
}
