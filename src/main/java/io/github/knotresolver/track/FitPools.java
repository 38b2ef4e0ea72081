package io.github.knotresolver.track;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.progress.Progress;

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
		return fitter(t, settings);
	}

	private FilamentFitter fitter(final int t, final FitSettings weights) {
		return new FilamentFitter(light.get(t), course.estimate().model(), links(),
			Optional.of(course.anchor().at(t)), weights.withClampWeight(course.anchor().weight(t)));
	}

	private int links() {
		return FilamentEstimator.links(course.estimate().length());
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
				fitter(t, settings.roughAndStiff(FitSettings.START_STIFFNESS)),
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
}
