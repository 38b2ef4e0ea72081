package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.contour.EqualArcDistance;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

/**
 * What is to be said of a result as a whole: that most of it is doubtful, so that the movie
 * may not be of the kind that can be resolved, or that nothing moves in it.
 */
final class Verdict {

	private static final String MOSTLY_DOUBTFUL = "Doubtful: the filament is in doubt in many other frames, and they tell about this one.";

	private static final String DOUBTED_BESIDE = "Doubtful: the filament is in doubt in the frames before and after this one.";

	private Verdict() {
	}

	/**
	 * @param filaments as they were found
	 * @return one sentence each; none about a result of which there is nothing to say
	 */
	static List<String> on(final List<FilamentTrack> filaments) {
		final List<String> verdict = new ArrayList<>();
		final List<Observation> all = followed(
			filaments.stream().flatMap(f -> f.frames().stream()).toList());
		final long likely = likely(all);
		if (isDoubtful(all))
			verdict.add(String.format(Locale.ROOT,
				"Doubtful as a whole: only %d of %d contours are more likely right than wrong; the movie may show something other than filaments, or more than can be followed. Look at the overlay before using any of it.",
				likely, all.size()));
		if (!filaments.isEmpty() && filaments.stream().allMatch(Verdict::standsStill))
			verdict.add(String.format(Locale.ROOT,
				"Nothing moves: %s the same in all frames to %.1f px, so the movie does not tell which end is fixed or which way to go at a crossing.",
				filaments.size() == 1 ? "the contour is" : "all contours are",
				SessionTuning.STILL));
		return verdict;
	}

	/** Whether most frames in which something was followed are more likely wrong than right. */
	static boolean isDoubtful(final List<Observation> frames) {
		final List<Observation> all = followed(frames);
		return all.size() >= SessionTuning.VERDICT_FRAMES
			&& likely(all) < SessionTuning.LIKELY_SHARE * all.size();
	}

	/**
	 * The frames of a movie tell about each other by length and motion: a contour cannot be sure
	 * where the filament is in doubt in most other frames, nor where it is so just before and after.
	 *
	 * @param frames of one filament, in order of time
	 * @return the same contours, with confidences that are never raised; what the user said stays
	 */
	static List<Observation> doubted(final List<Observation> frames) {
		final List<Observation> all = followed(frames);
		if (all.size() < SessionTuning.VERDICT_FRAMES)
			return frames;
		final double most = Math.max(SessionTuning.LIKELY,
			SessionTuning.SURE_BY_OTHERS * likely(all) / all.size());
		return IntStream.range(0, frames.size()).mapToObj(i -> {
			final Observation o = frames.get(i);
			return o.status() == FrameStatus.RESOLVED
				? o.atMost(most, MOSTLY_DOUBTFUL).atMost(beside(frames, i), DOUBTED_BESIDE)
				: o;
		}).toList();
	}

	/** The most that can be believed of a contour as the frames before and after it are. */
	private static double beside(final List<Observation> frames, final int i) {
		if (i < 1 || i + 1 == frames.size())
			return 1;
		final List<Observation> both = followed(List.of(frames.get(i - 1), frames.get(i + 1)));
		return both.size() < 2
			? 1
			: Math.max(SessionTuning.LIKELY,
				Math.max(both.get(0).confidence(), both.get(1).confidence()));
	}

	private static List<Observation> followed(final List<Observation> frames) {
		return frames.stream()
			.filter(o -> o.status() == FrameStatus.RESOLVED || o.status() == FrameStatus.UNRESOLVED)
			.toList();
	}

	private static long likely(final List<Observation> frames) {
		return frames.stream().filter(o -> o.confidence() > SessionTuning.LIKELY).count();
	}

	private static boolean standsStill(final FilamentTrack track) {
		final List<Polyline> contours = track.frames().stream().map(Observation::contour)
			.flatMap(Optional::stream).filter(c -> c.size() > 1).toList();
		return contours.size() >= SessionTuning.VERDICT_FRAMES && contours.stream().allMatch(
			c -> EqualArcDistance.mean(c, contours.get(contours.size() / 2)) < SessionTuning.STILL);
	}
}
