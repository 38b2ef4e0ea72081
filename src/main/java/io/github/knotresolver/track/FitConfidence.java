package io.github.knotresolver.track;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitQuality;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Observation;

/**
 * How likely it is that a frame's contour is right: a logistic function of what can be seen
 * after the fact (D. R. Cox, doi:10.1111/j.2517-6161.1958.tb00292.x). Its weights are none
 * negative, so that more of what speaks against a contour never raises its confidence. They
 * were fitted to movies with known truth by {@code scripts/fit-confidence}, on half of the
 * conditions; docs/method.md has the reliability on the other half.
 *
 * @param usualMisfit median misfit of the movie's chosen fits
 */
record FitConfidence(double usualMisfit) {

	/** In the order of {@link FitEvidence#NAMES}. */
	private static final double[] WEIGHTS = {5.14, 0, 7.17, 7.52, 15.33, 7.01, 2.64, 5.46, 2.67, 0,
		2, 7, 7, 7};

	static FitConfidence learn(final List<Optional<FitQuality>> quality) {
		final double[] misfits = quality.stream().flatMap(Optional::stream)
			.mapToDouble(FitQuality::misfit).toArray();
		return new FitConfidence(RobustStatistics.upperMedian(misfits, 1));
	}

	/** @return whether a fit differs visibly from all of some */
	static boolean differs(final Fit fit, final List<Fit> others) {
		return others.stream().allMatch(o -> o.chain().distance(fit.chain()) > TrackTuning.VISIBLE);
	}

	/** How much dearer the movie becomes with a visibly different contour in a frame. */
	static double gap(final TrellisPath path, final List<Fit> pool, final int frame) {
		final Fit chosen = pool.get(path.choice()[frame]);
		return path.gap(frame,
			v -> pool.get(v).chain().distance(chosen.chain()) > TrackTuning.VISIBLE);
	}

	/**
	 * The most that a confidence can be: if a contour that lies elsewhere by a line's width, be it
	 * only in part, costs the movie as much, either is right. Of contours that run along the same
	 * lines in another order the light tells nothing; what motion and bending tell must be more.
	 *
	 * @param sigma of the line in pixels
	 * @return 0.5 to 1
	 */
	static double atMost(final TrellisPath path, final List<Fit> pool, final int frame,
		final double sigma) {
		final Chain chosen = pool.get(path.choice()[frame]).chain();
		final double width = LineAppearance.FULL_WIDTH * sigma;
		final double elsewhere = path.gap(frame, v -> pool.get(v).chain().farthest(chosen) > width);
		final double exchanged = path.gap(frame,
			v -> isExchanged(pool.get(v).chain(), chosen, width));
		return 1 - 0.5 * Math.max(Math.exp(-elsewhere / TrackTuning.TIE),
			Math.exp(-exchanged / TrackTuning.EXCHANGED_TIE));
	}

	/** Whether a contour runs along the lines of another one, but visibly in another order. */
	static boolean isExchanged(final Chain other, final Chain chosen, final double width) {
		return other.farthest(chosen) > TrackTuning.EXCHANGED_APART * width
			&& isAlong(other, chosen, TrackTuning.EXCHANGED_ALONG * width)
			&& isAlong(chosen, other, TrackTuning.EXCHANGED_ALONG * width);
	}

	/** Whether all nodes of one lie so near to some link of another, in whatever order. */
	private static boolean isAlong(final Chain one, final Chain other, final double distance) {
		final Polyline nodes = one.polyline(), line = other.polyline();
		return IntStream.range(0, nodes.size())
			.allMatch(i -> line.distanceTo(nodes.point(i)) <= distance);
	}

	/** A gap as a figure: 1 if there is none, falling to 0. */
	static double rival(final double gap) {
		return Math.exp(-gap / TrackTuning.GAP_SCALE);
	}

	/** A misfit as a figure: 0 if it is usual. */
	double misfit(final FitQuality quality) {
		return usualMisfit > 0 ? Math.log(Math.max(1, quality.misfit() / usualMisfit)) : 0;
	}

	/**
	 * What is no more than a doubt takes no contour below one half: a good contour may fold, and a
	 * frame's contour may be right where others are not.
	 *
	 * @return 0..1
	 */
	static double of(final FitEvidence evidence) {
		double logit = TrackTuning.CONFIDENT;
		final double[] figures = evidence.figures();
		for (int i = 0; i < FitEvidence.DOUBTS; i++)
			logit -= WEIGHTS[i] * figures[i];
		double doubted = logit;
		for (int i = FitEvidence.DOUBTS; i < figures.length; i++)
			doubted -= WEIGHTS[i] * figures[i];
		return 1 / (1 + Math.exp(-Math.max(doubted, Math.min(logit, 0))));
	}

	/**
	 * What lowers a confidence, in words.
	 *
	 * @param most what it is at most, as {@link #atMost} says
	 * @return empty if it is high
	 */
	static String reason(final FitEvidence evidence, final double most) {
		if (of(evidence) < Observation.SURE)
			return reason(evidence);
		return most < Observation.SURE ? "Doubtful: " + FitEvidence.words(0) + "." : "";
	}

	/** What lowers a confidence, in words; empty if it is high. */
	static String reason(final FitEvidence evidence) {
		if (of(evidence) >= Observation.SURE)
			return "";
		final double[] figures = evidence.figures();
		final StringBuilder reason = new StringBuilder("Doubtful: ");
		int worst = 0;
		for (int i = 1; i < figures.length; i++)
			if (WEIGHTS[i] * figures[i] > WEIGHTS[worst] * figures[worst])
				worst = i;
		reason.append(FitEvidence.words(worst));
		for (int i = 0; i < figures.length; i++)
			if (i != worst && WEIGHTS[i] * figures[i] > TrackTuning.REASON)
				reason.append("; ").append(FitEvidence.words(i));
		return reason.append('.').toString();
	}
}
