
package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.track.SceneTracks.Filament;

/** The filaments of a scene as tracks. */
final class SceneDelivery {

	private SceneDelivery() {
	}

	/**
	 * @param found filaments
	 * @param first the number of the first one
	 * @param everyFrame completes the observations of the frames that were resolved
	 */
	static List<FilamentTrack> tracks(final List<Filament> found, final int first,
		final Function<List<Observation>, List<Observation>> everyFrame) {
		final List<FilamentTrack> tracks = new ArrayList<>();
		for (final Filament f : found)
			tracks.add(
				new FilamentTrack(first + tracks.size(), f.clamped() ? Anchor.CLAMPED : Anchor.FREE,
					f.clamped() ? fixedEnd(f) : Optional.empty(), f.length(), f.lengthError(),
					everyFrame.apply(f.frames())));
		return tracks;
	}

	/** Where the held end is: the median of the contours' first points. */
	static Optional<Point> fixedEnd(final Filament filament) {
		final List<Point> starts = filament.frames().stream().flatMap(o -> o.contour().stream())
			.map(c -> c.first()).toList();
		return starts.isEmpty() ? Optional.empty() : Optional.of(RobustStatistics.median(starts));
	}
}
