
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.model.Observation;

/**
 * Whether a filament was followed from the wrong end. Skeletons know ends to a pixel or two, in
 * which a long filament's tip may stay for a while, too; fits know them to a tenth.
 */
public final class StillerEnd {

	private static final String WHY = "Doubtful: the end that was taken for the fixed one moves as much as the other, so which one it is is a guess; tell fixed_end.";

	private StillerEnd() {
	}

	/**
	 * O(frames log frames).
	 *
	 * @param frames the movie
	 * @param found one filament in all of its frames, what was taken for the fixed end first
	 * @return the place of its tip in pixels if that stays in one place, and the other end does
	 *         not; empty if all is well
	 */
	public static Optional<Point> of(final List<FrameView> frames, final List<Observation> found) {
		final List<Point> starts = new ArrayList<>(), tips = new ArrayList<>();
		for (int t = 0; t < frames.size(); t++) {
			final Optional<Polyline> contour = found.get(t).contour();
			if (contour.isPresent() && !FreeEnds.atBorder(frames.get(t), contour.get().last())) {
				starts.add(contour.get().first());
				tips.add(contour.get().last());
			}
		}
		if (tips.size() < TrackTuning.NEARLY_ALL * frames.size())
			return Optional.empty();
		final Point start = RobustStatistics.median(starts), tip = RobustStatistics.median(tips);
		final double held = spread(tips, tip), loose = spread(starts, start);
		return loose > TrackTuning.STILL_END && held < TrackTuning.HELD_SHARE * loose
			? Optional.of(tip)
			: Optional.empty();
	}

	/**
	 * Takes the confidence off all frames if nothing tells which end is held. O(frames log frames).
	 *
	 * @param found one filament in all frames, what was taken for the fixed end first
	 * @return the same contours, none of which is believed if that end moves like the other
	 */
	public static List<Observation> doubted(final List<Observation> found) {
		final List<Polyline> contours = found.stream().flatMap(o -> o.contour().stream()).toList();
		final double start = step(contours, Polyline::first), tip = step(contours, Polyline::last);
		return start > TrackTuning.LEAST_MOTION && start > TrackTuning.RESTLESS * tip
			? found.stream().map(o -> o.doubted(TrackTuning.TURNED, WHY)).toList()
			: found;
	}

	/** Median step of an end from contour to contour. */
	private static double step(final List<Polyline> contours, final Function<Polyline, Point> end) {
		return RobustStatistics.median(IntStream.range(1, contours.size())
			.mapToDouble(t -> end.apply(contours.get(t - 1)).distanceTo(end.apply(contours.get(t))))
			.toArray(), 0);
	}

	private static double spread(final List<Point> places, final Point middle) {
		return RobustStatistics.median(places.stream().mapToDouble(middle::distanceTo).toArray());
	}
}
