package io.github.knotresolver.ui.model;

import java.util.HashMap;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;

/** What differs between two results of a movie. */
final class Changes {

	/** ROIs keep a contour to so many pixels. */
	private static final double ROUNDING = 0.01;

	private Changes() {
	}

	/** @return whether a contour is not the one that a result has there */
	static boolean isOther(final Tracks tracks, final Constraint contour) {
		return tracks.filaments().stream().filter(f -> f.id() == contour.filament())
			.filter(f -> contour.frame() <= f.frames().size())
			.anyMatch(f -> f.frames().get(contour.frame() - 1).contour()
				.filter(c -> isSame(c, contour.shape())).isEmpty());
	}

	private static boolean isSame(final Polyline a, final Polyline b) {
		for (int i = 0; i < Math.min(a.size(), b.size()); i++)
			if (a.point(i).distanceTo(b.point(i)) > ROUNDING)
				return false;
		return a.size() == b.size();
	}

	/** @return where contour or status are not the same; filaments that only one has are left out */
	static SortedSet<Edits.Place> between(final Tracks before, final Tracks after) {
		final Map<Integer, FilamentTrack> earlier = new HashMap<>();
		before.filaments().forEach(f -> earlier.put(f.id(), f));
		final SortedSet<Edits.Place> changed = new TreeSet<>();
		for (final FilamentTrack track : after.filaments())
			if (earlier.containsKey(track.id()))
				for (final Observation now : track.frames()) {
					final Observation then = earlier.get(track.id()).frames().get(now.frame() - 1);
					if (now.status() != then.status() || !now.contour().equals(then.contour()))
						changed.add(new Edits.Place(track.id(), now.frame()));
				}
		return changed;
	}
}
