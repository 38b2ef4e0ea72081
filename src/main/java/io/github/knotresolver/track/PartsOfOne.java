package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.track.SceneTracks.Filament;

/**
 * Filaments that may be parts of one: a ring, and what lies within it. Each explains its own light,
 * but one of them is doubted in all frames, and the other begins or ends on it in nearly all.
 */
final class PartsOfOne {

	private static final String WHY = "Doubtful: this filament begins or ends on another that is doubtful in all frames, and may be a part of it.";

	private PartsOfOne() {
	}

	/**
	 * O(filaments² frames length).
	 *
	 * @param filaments as they were found
	 * @return the same in the same order; those that may be a part of another are doubted, too
	 */
	static List<Filament> doubted(final List<Filament> filaments) {
		final List<Filament> guessed = filaments.stream().filter(PartsOfOne::isGuessed).toList();
		return filaments.stream()
			.map(f -> guessed.stream()
				.anyMatch(other -> other != f
					&& (ends(f, Polyline::first, other) || ends(f, Polyline::last, other)))
						? doubted(f)
						: f)
			.toList();
	}

	private static boolean isGuessed(final Filament filament) {
		return filament.frames().stream()
			.allMatch(o -> o.contour().isEmpty() || o.confidence() <= TrackTuning.GUESSED);
	}

	/** Whether an end of a filament is on another in nearly all frames in which both are seen. */
	private static boolean ends(final Filament filament, final Function<Polyline, Point> end,
		final Filament other) {
		final List<Observation> a = filament.frames(), b = other.frames();
		final double[] apart = IntStream.range(0, a.size())
			.mapToObj(t -> a.get(t).contour().map(end)
				.flatMap(e -> b.get(t).contour().map(c -> c.distanceTo(e))))
			.flatMap(Optional::stream).mapToDouble(d -> d).toArray();
		return apart.length > 0 && Arrays.stream(apart).filter(d -> d < SceneTuning.SWAP_TOUCH)
			.count() >= TrackTuning.NEARLY_ALL * apart.length;
	}

	private static Filament doubted(final Filament f) {
		return new Filament(f.clamped(), f.roams(), f.length(), f.lengthError(),
			f.frames().stream().map(o -> o.atMost(TrackTuning.GUESSED, WHY)).toList());
	}
}
