package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.EndLight;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.FitQuality;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Residue;
import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * The frames in which the filament lies open: one trail from a free end to a free end
 * explains all of its object and does not cross itself. There, a fit with both ends free
 * says where the clamp is and how long the filament is. Where there is no such frame for long,
 * those are taken in which the trail crosses itself and the fit explains all light: whichever
 * way it goes at a crossing, its length is the same.
 *
 * @param seen the fits, in order of time
 */
record OpenFrames(List<Seen> seen) {

	/**
	 * An open filament.
	 *
	 * @param index of the frame
	 * @param chain as fitted
	 * @param fixedEndSeen whether its fixed end is in the picture
	 * @param tipSeen whether its tip is
	 * @param crossed whether it crosses itself, so that its shape may be wrong, but not its length
	 */
	record Seen(int index, Chain chain, boolean fixedEndSeen, boolean tipSeen, boolean crossed) {

		boolean isWhole() {
			return fixedEndSeen && tipSeen;
		}
	}

	/**
	 * Fits the open frames.
	 *
	 * @param frames the movie
	 * @param light their pixels, a strand's brightness 1
	 * @param sets the trails of each frame
	 * @param estimate what the filament looks like
	 * @param endsFree weights of a fit with both ends and the length free
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	static OpenFrames find(final List<FrameView> frames, final List<NormalizedFrame> light,
		final List<CandidateSet> sets, final FilamentEstimate estimate, final FitSettings endsFree,
		final Workers workers, final Progress progress) {
		final List<Optional<Seen>> seen = workers.map("Looking at open frames", progress,
			frames.size(), t -> clear(sets.get(t)).filter(OpenFrames::isOpen)
				.flatMap(c -> fitted(t, frames, light, c, estimate, endsFree)));
		final boolean[] closed = inLongRun(seen);
		final List<Optional<Seen>> more = workers.map("Looking at crossed frames", progress,
			frames.size(),
			t -> closed[t]
				? clear(sets.get(t)).filter(c -> !isOpen(c))
					.flatMap(c -> fitted(t, frames, light, c, estimate, endsFree))
				: seen.get(t));
		return new OpenFrames(more.stream().flatMap(Optional::stream).toList()).withoutSameAgain();
	}

	/**
	 * Without crossed frames that are about as long as the open ones: these know the length
	 * better, since a dim tip that lies on the filament is missed and hardly any light with it.
	 */
	private OpenFrames withoutSameAgain() {
		final double[] open = seen.stream().filter(s -> !s.crossed && s.isWhole())
			.mapToDouble(s -> s.chain.length()).toArray();
		if (open.length == 0)
			return this;
		final double usual = new Median().evaluate(open);
		return new OpenFrames(seen.stream()
			.filter(
				s -> !s.crossed || Math.abs(s.chain.length() / usual - 1) > TrackTuning.OPEN_BROKEN)
			.toList());
	}

	/** The best trail if it runs from a free end to a free end and leaves nothing out. */
	private static Optional<Candidate> clear(final CandidateSet set) {
		return set.candidates().stream().findFirst()
			.filter(c -> c.price().uncovered() <= TrackTuning.OPEN_LEFT_OUT && !c.endsInside()
				&& c.steps().get(0).from().isFreeEnd()
				&& c.steps().get(c.steps().size() - 1).to().isFreeEnd());
	}

	private static boolean isOpen(final Candidate c) {
		return c.price().overlap() <= TrackTuning.OPEN_TWICE
			&& Crossings.of(ContourBuilder.smooth(c)).isEmpty();
	}

	/** For every frame whether it is in a long run of frames in which nothing was seen. */
	private static boolean[] inLongRun(final List<Optional<Seen>> seen) {
		final boolean[] in = new boolean[seen.size()];
		int first = 0;
		for (int t = 0; t <= in.length; t++)
			if (t == in.length || seen.get(t).isPresent()) {
				if (t - first >= TrackTuning.OPEN_LONG)
					Arrays.fill(in, first, t, true);
				first = t + 1;
			}
		return in;
	}

	private static Optional<Seen> fitted(final int t, final List<FrameView> frames,
		final List<NormalizedFrame> light, final Candidate best, final FilamentEstimate estimate,
		final FitSettings endsFree) {
		final Polyline contour = ContourBuilder.smooth(best);
		if (contour.size() < 2 || contour.length() < TrackTuning.SPOT * estimate.model().sigma())
			return Optional.empty();
		final boolean crossed = !isOpen(best);
		if (crossed && best.price().overlap() > TrackTuning.CROSSED_TWICE * contour.length())
			return Optional.empty();
		final NormalizedFrame frame = light.get(t);
		final int links = FilamentEstimator.links(estimate.length());
		final EndLight ends = new EndLight(frame, estimate.model(), frame.noise());
		final Chain first = FilamentEstimator.fromSkeleton(frame, estimate.model(),
			Chain.along(contour, links, contour.length()), endsFree);
		final Chain settled = ends.settled(first);
		final Chain chain = settled == first
			? first
			: new FilamentFitter(frame, estimate.model(), links, Optional.empty(), endsFree)
				.fit(settled, Optional.empty()).chain();
		if (Math.abs(chain.length() / contour.length() - 1) > TrackTuning.OPEN_ASTRAY
			|| FitQuality.of(frame, estimate.model(), chain).dark() > TrackTuning.OPEN_DARK)
			return Optional.empty();
		final Residue left = Residue.of(frame, estimate.model(), chain);
		if (crossed && left.unexplained() + left.invented() > TrackTuning.CROSSED_UNEXPLAINED)
			return Optional.empty();
		return Optional.of(new Seen(t, chain, !FreeEnds.atBorder(frames.get(t), chain.start()),
			!FreeEnds.atBorder(frames.get(t), chain.tip()), crossed));
	}

	/** The open frames in which the fixed end was seen. */
	List<Seen> withFixedEnd() {
		return seen.stream().filter(s -> s.fixedEndSeen && !s.crossed).toList();
	}

	/** The frames in which both ends were seen. */
	List<Seen> whole() {
		return seen.stream().filter(Seen::isWhole).toList();
	}
}
