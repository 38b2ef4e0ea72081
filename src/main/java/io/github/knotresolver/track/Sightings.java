package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.fit.FilamentEstimator.Sighting;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Cancellation;

/**
 * Chooses the frames in which the contour is beyond doubt, from which the line
 * and the filament's length are learned: unbranched skeletons if there are some,
 * else those whose best trail is cheapest and does not cross itself.
 */
final class Sightings {

	private Sightings() {
	}

	private record Seen(FrameView frame, Polyline contour, List<Polyline> others, double doubt,
		double price) {

		/** Whether it lies on itself, crosses itself, or ends where it runs into itself. */
		boolean isWound() {
			final double before = contour.length() - TrackTuning.SIGHTED;
			return doubt > 0 || before > 0
				&& contour.head(before).distanceTo(contour.last()) < TrackTuning.RUNS_INTO;
		}

		/** Whether both ends are inside the picture. */
		boolean isWhole() {
			return !FreeEnds.atBorder(frame, contour.first())
				&& !FreeEnds.atBorder(frame, contour.last());
		}
	}

	/**
	 * @param frames the movie
	 * @param sets the trails of each frame
	 * @return the clearest frames, the clearest first; none if there is no contour at
	 *         all
	 */
	static List<Sighting> choose(final List<FrameView> frames, final List<CandidateSet> sets) {
		final List<Seen> seen = new ArrayList<>();
		for (int t = 0; t < sets.size(); t++) {
			Cancellation.check();
			if (!sets.get(t).candidates().isEmpty())
				look(frames.get(t), sets.get(t).candidates(), seen);
		}
		if (seen.isEmpty())
			return List.of();
		final List<Seen> whole = seen.stream().filter(Seen::isWhole).toList();
		return of(whole.size() >= TrackTuning.SIMPLE_FRAMES ? whole : seen);
	}

	/**
	 * Frames of a movie that was solved, in which the tip is free; O(frames * length).
	 *
	 * @param frames the movie
	 * @param solved their contours
	 * @param model what a line looks like
	 * @param most no more than so many
	 * @return those that are explained best, the best first; none if they are too few
	 */
	static List<Sighting> solved(final List<FrameView> frames, final FitTrellis.Solved solved,
		final LineModel model, final int most) {
		final int[] free = IntStream.range(0, frames.size())
			.filter(t -> GuessedLength.isTipFree(solved.frames().get(t), model)).toArray();
		return free.length < TrackTuning.SIMPLE_FRAMES
			? List.of()
			: Arrays.stream(free).boxed()
				.sorted(Comparator
					.comparingDouble(t -> solved.looks().get(t).orElseThrow().residue().pattern()))
				.limit(most).map(t -> new Sighting(frames.get(t).light(),
					solved.frames().get(t).contour().orElseThrow()))
				.toList();
	}

	private static List<Sighting> of(final List<Seen> seen) {
		final List<Seen> simple = seen.stream().filter(s -> s.frame.graph().isUnbranched())
			.toList();
		final List<Seen> from = simple.size() >= TrackTuning.SIMPLE_FRAMES ? simple : seen;
		final double[] lengths = from.stream().mapToDouble(s -> s.contour.length()).sorted()
			.toArray();
		final double length = lengths[(int) (lengths.length * TrackTuning.SIGHTED_QUANTILE)];
		// Where many frames show it open, other ways through the rest teach what is wrong.
		final boolean open = from == simple || from.stream().filter(s -> !s.isWound())
			.count() >= Math.max(TrackTuning.SIMPLE_FRAMES, TrackTuning.OFTEN_OPEN * from.size());
		return from.stream()
			.filter(s -> Math.abs(s.contour.length() / length - 1) < TrackTuning.SIGHTED_TOLERANCE)
			.sorted(Comparator.comparingDouble(Seen::price)).limit(TrackTuning.SIGHTINGS)
			.map(s -> new Sighting(s.frame.light(), s.contour, open ? List.of() : s.others))
			.toList();
	}

	private static void look(final FrameView frame, final List<Candidate> trails,
		final List<Seen> seen) {
		final Candidate best = trails.get(0);
		final Polyline contour = ContourBuilder.smooth(best);
		if (contour.size() < 2 || contour.length() < TrackTuning.SIGHTED)
			return;
		// A doubtful contour is used only where there is none better.
		final double doubt = best.price().overlap()
			+ Crossings.of(contour).size() * contour.length();
		final List<Polyline> others = trails.stream().skip(1).limit(TrackTuning.OTHER_WAYS)
			.map(ContourBuilder::smooth).filter(c -> c.length() >= TrackTuning.SIGHTED).toList();
		seen.add(new Seen(frame, contour, others, doubt, best.price().total() + doubt));
	}
}
