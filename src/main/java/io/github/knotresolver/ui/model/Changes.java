package io.github.knotresolver.ui.model;

import java.util.HashMap;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;

import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;

/** What differs between two results of a movie. */
final class Changes {

	private Changes() {
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
