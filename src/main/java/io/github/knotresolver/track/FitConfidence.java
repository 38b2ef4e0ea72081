package io.github.knotresolver.track;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitQuality;

/**
 * How sure it is that a frame's contour is right. Two things speak for it: every
 * visibly different contour makes the whole movie dearer (the gap of the trellis), and
 * the contour explains its frame as well as contours of this movie usually do. Bright
 * objects that it touches but does not run along speak against it.
 *
 * @param usualMisfit median misfit of the movie's chosen fits
 */
record FitConfidence(double usualMisfit) {

	/** A gap of this price gives a confidence of 63 %. */
	private static final double GAP_SCALE = 2;

	/** So much uncovered skeleton, relative to the contour, may be debris. */
	private static final double DEBRIS = 0.2;

	/** Fits nearer than this (pixels, at equal arc length) do not differ visibly. */
	private static final double VISIBLE = 2.5;

	/** Misfit, as a multiple of the usual one, that says nothing against a fit ... */
	private static final double USUAL = 1.3;

	/** ... and that leaves no confidence. */
	private static final double HOPELESS = 2.5;

	static FitConfidence learn(final List<Optional<FitQuality>> quality) {
		final double[] misfits = quality.stream().flatMap(Optional::stream)
			.mapToDouble(FitQuality::misfit).sorted().toArray();
		return new FitConfidence(misfits.length == 0 ? 1 : misfits[misfits.length / 2]);
	}

	/** @return whether a fit differs visibly from all of some */
	static boolean differs(final Fit fit, final List<Fit> others) {
		return others.stream().allMatch(o -> o.chain().distance(fit.chain()) > VISIBLE);
	}

	/** How much dearer the movie becomes with a visibly different contour in a frame. */
	static double gap(final TrellisPath path, final List<Fit> pool, final int frame) {
		final Fit chosen = pool.get(path.choice()[frame]);
		return path.gap(frame, v -> pool.get(v).chain().distance(chosen.chain()) > VISIBLE);
	}

	double of(final double gap, final FitQuality quality, final double uncovered) {
		final double multiple = quality.misfit() / usualMisfit;
		final double agreement = Math.min(1,
			Math.max(0, (HOPELESS - multiple) / (HOPELESS - USUAL)));
		final double covered = Math.min(1, Math.max(0, (1 - uncovered) / (1 - DEBRIS)));
		return (1 - Math.exp(-gap / GAP_SCALE)) * agreement * (1 - quality.dark()) * covered;
	}
}
