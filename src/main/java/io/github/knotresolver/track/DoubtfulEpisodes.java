
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.track.SceneTracks.Filament;

/** The frames in which a filament is not sure, and the filaments that it touches there. */
final class DoubtfulEpisodes {

	private final List<Filament> filaments;

	/** @param filaments numbered from 1 in this order */
	DoubtfulEpisodes(final List<Filament> filaments) {
		this.filaments = filaments;
	}

	/** A sentence for each episode. */
	List<String> notes() {
		final List<String> notes = new ArrayList<>();
		for (int k = 0; k < filaments.size(); k++) {
			final List<Observation> frames = filaments.get(k).frames();
			int from = -1;
			for (int t = 0; t <= frames.size(); t++) {
				final boolean doubtful = t < frames.size() && isDoubtful(frames.get(t));
				if (doubtful && from < 0)
					from = t;
				if (!doubtful && from >= 0) {
					notes.add(note(k, from, t - 1));
					from = -1;
				}
			}
		}
		if (notes.size() <= TrackTuning.EPISODES)
			return notes;
		final List<String> first = new ArrayList<>(notes.subList(0, TrackTuning.EPISODES));
		first.add(notes.size() - TrackTuning.EPISODES
			+ " more episodes are doubtful; the confidence of each frame says which.");
		return first;
	}

	private static boolean isDoubtful(final Observation o) {
		return o.contour().isPresent() && o.confidence() < TrackTuning.DOUBTFUL;
	}

	private String note(final int k, final int from, final int to) {
		final TreeSet<Integer> touched = new TreeSet<>();
		for (int t = from; t <= to; t++)
			for (int other = 0; other < filaments.size(); other++)
				if (other != k && touches(k, other, t))
					touched.add(other + 1);
		final List<Observation> frames = filaments.get(k).frames();
		final int first = frames.get(from).frame(), last = frames.get(to).frame();
		return "Filament " + (k + 1) + " is doubtful in "
			+ (first == last ? "frame " + first : "frames " + first + " to " + last)
			+ (touched.isEmpty()
				? "."
				: ", where it touches filament " + touched.toString().replaceAll("[\\[\\]]", "")
					+ ": they may have been exchanged.");
	}

	private boolean touches(final int k, final int other, final int t) {
		final var a = filaments.get(k).frames().get(t).contour();
		final var b = filaments.get(other).frames().get(t).contour();
		return a.isPresent() && b.isPresent() && touch(a.get(), b.get());
	}

	private static boolean touch(final Polyline a, final Polyline b) {
		for (int i = 0; i < a.size(); i++)
			for (int j = 0; j < b.size(); j++)
				if (Math.hypot(a.x(i) - b.x(j), a.y(i) - b.y(j)) < SceneTuning.TOUCH)
					return true;
		return false;
	}
}
