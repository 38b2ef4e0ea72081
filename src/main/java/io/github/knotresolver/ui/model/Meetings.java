package io.github.knotresolver.ui.model;

import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;

/** When a filament crosses which. */
final class Meetings {

	/** Spacing of points that shows a crossing, in pixels. */
	private static final double STEP = 2;

	private Meetings() {
	}

	/**
	 * @return frames by the number of the filament that is crossed, which may be its own; others that
	 *         are never crossed are left out
	 */
	static SortedMap<Integer, SortedSet<Integer>> of(final Tracks tracks,
		final FilamentTrack track) {
		final SortedMap<Integer, SortedSet<Integer>> met = new TreeMap<>();
		for (final Observation o : track.frames()) {
			if (o.contour().isEmpty())
				continue;
			final Polyline mine = o.contour().get().resampled(STEP);
			for (final FilamentTrack other : tracks.filaments())
				if (meets(other, o, mine, other.id() == track.id()))
					met.computeIfAbsent(other.id(), k -> new TreeSet<>()).add(o.frame());
		}
		return met;
	}

	private static boolean meets(final FilamentTrack other, final Observation o,
		final Polyline mine, final boolean self) {
		return self
			? o.crossings() > 0
			: other.frames().get(o.frame() - 1).contour().map(c -> c.resampled(STEP))
				.filter(c -> Crossings.isBetween(mine, c)).isPresent();
	}
}
