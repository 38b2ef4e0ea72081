package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * All that was found in a movie before the user said anything: it is made once, and every
 * answer is chosen from it.
 *
 * @param frames the frames, in order of time
 * @param light their pixels, a strand's brightness 1
 * @param course line, length and fixed end
 * @param sets the candidates of every frame
 * @param fits the fits of every frame
 * @param settings weights of the fits
 */
record FitPools(List<FrameView> frames, List<NormalizedFrame> light, FilamentCourse course,
	List<CandidateSet> sets, List<List<Fit>> fits, FitSettings settings) {

	/** A place has two coordinates, each of which fits the noise of a pixel. */
	private static final int FREEDOM = 2;

	/** @return price of all frames' cheapest fits; a frame that nothing explains costs nothing */
	double price() {
		return fits.stream()
			.mapToDouble(f -> f.stream().mapToDouble(Fit::energy).reduce(0, Math::min)).sum();
	}

	/**
	 * Of a fixed end that moves, as here, and one that stays, the one that explains more light: a
	 * place of its own in each frame explains some of the noise.
	 *
	 * @param still what is found if it stays
	 * @return one of both
	 */
	FitPools orStill(final FitPools still) {
		final double noise = course.noise();
		return still.price() < price() + FREEDOM * noise * noise * fits.size() ? still : this;
	}

	/** @return the fitter of a frame */
	FilamentFitter fitter(final int t) {
		return fitter(t, settings, links());
	}

	private FilamentFitter fitter(final int t, final FitSettings weights, final int links) {
		return new FilamentFitter(light.get(t), course.estimate().model(), links,
			Optional.of(course.anchor().at(t)), weights.withClampWeight(course.anchor().weight(t)));
	}

	private int links() {
		return FilamentEstimator.links(course.estimate().length());
	}

	/**
	 * What all frames say together of the length, each by where its light ends: where few show the
	 * filament open, or noise or something bright beside it hides an end in these, all know it better
	 * than the clearest. A frame in which the tip lies on the filament, or is outside, says nothing.
	 * O(frames * length).
	 *
	 * @param chosen the contours that were chosen, by index of the frame
	 * @param workers threads
	 * @return the course with that length; empty if that is not surely another, or the length changes
	 */
	Optional<FilamentCourse> lengthOfAll(final List<Observation> chosen, final Workers workers) {
		if (course.length().kind() != LengthCourse.Kind.CONSTANT)
			return Optional.empty();
		final FilamentEstimate known = course.estimate();
		final double[] seen = workers.map(chosen.size(),
			t -> GuessedLength.isTipFree(chosen.get(t), known.model())
				? freeLength(t, chosen.get(t).contour().orElseThrow())
				: Double.NaN)
			.stream().mapToDouble(l -> l).filter(Double::isFinite).toArray();
		return Lengths.common(seen).filter(c -> c.isOtherThan(known.length()))
			.map(c -> course.withEstimate(known.withLength(c.length(), c.error()))
				.withLength(LengthCourse.constant(c.length(), chosen.size())));
	}

	/**
	 * The same contours as long as the filament is on another course, fitted again: much less work
	 * than to find them anew, and where the length is hardly another one finds the same. What is too
	 * dear to be chosen stays as it was found. O(frames * fits * length).
	 *
	 * @param other the same line and fixed end, another constant length
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	FitPools withCourse(final FilamentCourse other, final Workers workers,
		final Progress progress) {
		final FitPools empty = new FitPools(frames, light, other, sets, fits, settings);
		return new FitPools(frames, light, other, sets,
			workers.map("Fitting the contours", progress, fits.size(), empty::again), settings);
	}

	private List<Fit> again(final int t) {
		final FilamentFitter fitter = fitter(t);
		final double dearest = TrackTuning.COURSE_HOPELESS
			+ fits.get(t).stream().mapToDouble(Fit::energy).min().orElse(0);
		final FitPool pool = new FitPool();
		for (final Fit fit : fits.get(t)) {
			final Chain resized = fit.chain().resized(course.length().of(t)).divided(links());
			pool.add(fit.energy() < dearest
				? fitter.fit(resized, Optional.empty(), dearest)
				: fitter.price(resized));
		}
		return pool.fits();
	}

	private double freeLength(final int t, final Polyline contour) {
		return fitter(t, settings.withFreeLength(true), links())
			.fit(Chain.along(contour, links(), contour.length()), Optional.empty()).chain()
			.length();
	}

	/** @return the fits of a frame that are as the user said; further ones if none at hand is */
	List<Fit> restricted(final int t, final Restriction said) {
		final FitProposals proposals = new FitProposals(frames.get(t), course.in(t), links(),
			settings.freeLength());
		if (said.contour().isPresent())
			return proposals.of(said.contour().get(), fitter(t));
		final List<Fit> atHand = met(fits.get(t), said);
		return atHand.isEmpty()
			? met(proposals.of(sets.get(t), fitter(t),
				fitter(t, settings.roughAndStiff(FitSettings.START_STIFFNESS),
					FitProposals.stiffLinks(links())),
				said::isNearlyMetBy), said)
			: atHand;
	}

	private static List<Fit> met(final List<Fit> fits, final Restriction said) {
		return fits.stream().filter(f -> said.isMetBy(f.chain().contour())).toList();
	}

	/** @return what carries fits of a frame to its neighbours */
	Propagation propagation(final int width, final Progress progress) {
		return new Propagation(width, MotionPrice.learn(fits, course.anchor()), this::fitter, fits,
			new Propagation.Frames(course, settings.freeLength()), progress);
	}

	/**
	 * The same, and wherever two strands of a frame's likely contour may have been exchanged, the
	 * contour on which they are. Not if each fit has a length of its own, as then it tells little.
	 *
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	FitPools withExchanges(final Workers workers, final Progress progress) {
		FitPools pools = this;
		for (int round = 0; round < TrackTuning.EXCHANGE_ROUNDS && !settings.freeLength(); round++)
			pools = pools.exchanged(workers, progress);
		return pools;
	}

	private FitPools exchanged(final Workers workers, final Progress progress) {
		final TrellisPath path = FitTrellis
			.course(fits, course.anchor(), MotionPrice.learn(fits, course.anchor()), progress)
			.path();
		return new FitPools(frames, light, course, sets,
			workers.map("Exchanging strands", progress, fits.size(),
				t -> path.choice()[t] < 0 ? fits.get(t) : exchanged(t, path.choice()[t])),
			settings);
	}

	private List<Fit> exchanged(final int t, final int chosen) {
		final Fit fit = fits.get(t).get(chosen);
		final double width = LineAppearance.FULL_WIDTH * course.estimate().model().sigma();
		final double seen = TrackTuning.STRANDS_SEEN * width;
		final FitProposals proposals = new FitProposals(frames.get(t), course.in(t), links(),
			settings.freeLength());
		final List<Fit> all = new ArrayList<>(fits.get(t));
		for (final Polyline other : new StrandExchange(fit.chain(), width).contours()) {
			final Chain start = proposals.start(other);
			if (isNear(start, all, TrackTuning.STRANDS_SAME * width))
				continue;
			final Fit exchanged = fitter(t).fit(start, Optional.empty(),
				fit.energy() + TrackTuning.HOPELESS);
			if (exchanged.energy() < fit.energy() + TrackTuning.HOPELESS
				&& !isNear(exchanged.chain(), all, seen))
				all.add(exchanged);
		}
		return List.copyOf(all);
	}

	private static boolean isNear(final Chain chain, final List<Fit> fits, final double near) {
		return fits.stream().anyMatch(f -> f.chain().farthest(chain) < near);
	}
}
