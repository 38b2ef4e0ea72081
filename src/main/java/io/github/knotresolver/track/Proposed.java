package io.github.knotresolver.track;

import java.util.List;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.NormalizedFrame;

/**
 * What the graphs propose if a filament's course is as it is taken to be, fitted to the
 * pictures.
 *
 * @param course what is known of the filament in every frame
 * @param light the frames, a strand's brightness 1
 * @param sets the trails of each frame
 * @param fits the fitted ones of each frame
 */
record Proposed(FilamentCourse course, List<NormalizedFrame> light, List<CandidateSet> sets,
	List<List<Fit>> fits) {

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
	 * @param still what is proposed if it stays
	 * @return one of both
	 */
	Proposed orStill(final Proposed still) {
		final double noise = course.noise();
		return still.price() < price() + FREEDOM * noise * noise * fits.size() ? still : this;
	}
}
