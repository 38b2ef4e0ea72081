package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;

/**
 * Where a filament may be one frame on if it moves far between frames: it has slid along
 * itself, towards its fixed end or away, and wound up or unwound. Many such shapes are
 * compared with the picture as they are, and the best few are starts of a fit. Only the best
 * hypothesis is asked for them: others that wind up are proposed by the graph as well.
 *
 * @param reach usual motion between frames in pixels
 */
record WoundStarts(double reach) {

	/** How far it slides, in multiples of usual motion. */
	private static final double[] SLIDES = {0.5, 1, 1.5, 2, 3};

	/** Where it winds up, as part of the length. */
	private static final double[] PLACES = {0.04, 0.1, 0.2, 0.35};

	/** @return the most promising starts; none for a filament that moves little */
	List<Chain> of(final Chain here, final FilamentFitter fitter) {
		final List<Chain> starts = new ArrayList<>();
		if (reach < TrackTuning.FAST)
			return starts;
		final List<Fit> rough = new ArrayList<>();
		for (final double place : PLACES)
			for (final double slide : SLIDES) {
				final int at = (int) Math.rint(place * here.links());
				final int by = (int) Math.rint(slide * reach / here.linkLength());
				if (by > 0 && by < here.links() - at)
					for (final int way : new int[]{by, -by})
						rough.add(fitter.price(here.wound(at, way)));
			}
		rough.sort(Comparator.comparingDouble(Fit::energy));
		for (final Fit f : rough)
			if (starts.size() < TrackTuning.WOUND_BEST
				&& starts.stream().allMatch(s -> s.distance(f.chain()) > TrackTuning.WOUND_SAME))
				starts.add(f.chain());
		return starts;
	}
}
