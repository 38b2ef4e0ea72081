package io.github.knotresolver.ui.model;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Alternative;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;

/**
 * A result that is looked at: a filament in a frame, and where to look next. Safe to use from several
 * threads.
 */
abstract class ResultView {

	private final Movie movie;
	private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
	private Optional<Tracks> tracks = Optional.empty();
	private SortedMap<Integer, SortedSet<Integer>> meetings = new TreeMap<>();
	private SortedSet<Edits.Place> changed = new TreeSet<>();
	private int frame = 1;
	private int filament = 1;

	ResultView(final Movie movie) {
		this.movie = movie;
	}

	/** @return the movie under review */
	public Movie movie() {
		return movie;
	}

	/** @param listener told after every change */
	public void listen(final Runnable listener) {
		listeners.add(listener);
	}

	final void tell() {
		listeners.forEach(Runnable::run);
	}

	/** @return the frame that is looked at, from 1 */
	public synchronized int frame() {
		return frame;
	}

	/** @param wanted a frame, from 1; beyond the movie's ends, the nearest */
	public void goTo(final int wanted) {
		synchronized (this) {
			final int next = Math.max(1, Math.min(movie.size(), wanted));
			if (next == frame)
				return;
			frame = next;
		}
		tell();
	}

	/** @return the number of the filament that is looked at, from 1 */
	public synchronized int filament() {
		return filament;
	}

	/** @param wanted number of a filament; one that there is not changes nothing */
	public void choose(final int wanted) {
		synchronized (this) {
			if (tracks.isEmpty()
				|| tracks.get().filaments().stream().noneMatch(f -> f.id() == wanted))
				return;
			filament = wanted;
			meet();
		}
		tell();
	}

	/** @return the result; empty until the movie has been solved once */
	public synchronized Optional<Tracks> tracks() {
		return tracks;
	}

	/** @return the filament that is looked at, in all frames; empty likewise */
	public synchronized Optional<FilamentTrack> track() {
		return tracks
			.flatMap(t -> t.filaments().stream().filter(f -> f.id() == filament).findFirst());
	}

	/** @return what was found of the filament in the frame; empty likewise */
	public synchronized Optional<Observation> shown() {
		return track().map(t -> t.frames().get(frame - 1));
	}

	/** @return other contours for this frame, cheapest first; none until the movie is solved */
	public synchronized List<Alternative> alternatives() {
		return shown().map(Observation::alternatives).orElse(List.of());
	}

	/** @return the confidence of each frame, 0..1; NaN where there is no contour */
	public synchronized double[] confidences() {
		final double[] all = new double[movie.size()];
		Arrays.setAll(all,
			t -> track().map(f -> f.frames().get(t).confidence()).orElse(Double.NaN));
		return all;
	}

	/**
	 * @param wanted a frame, from 1
	 * @return whether the filament need not have a contour there: it is not in view, or the frame is
	 *         left out
	 */
	public synchronized boolean isLeftOut(final int wanted) {
		return track().map(t -> t.frames().get(wanted - 1).status())
			.filter(s -> s == FrameStatus.ABSENT || s == FrameStatus.IGNORED).isPresent();
	}

	/** @return the frames to look at, the least certain first; without those that were accepted */
	public synchronized List<Integer> doubtful() {
		return track().map(t -> Doubts.of(tracks.orElseThrow(), t)).orElse(List.of());
	}

	/** Goes to the next less certain frame; from any other frame to the least certain. */
	public void nextDoubtful() {
		step(1);
	}

	/** Goes to the frame before in the order of doubt; from any other frame to the most certain. */
	public void previousDoubtful() {
		step(-1);
	}

	private void step(final int by) {
		goTo(Doubts.step(doubtful(), frame(), by));
	}

	/** @return whether a frame was accepted, or its contour is as a person said */
	public synchronized boolean isChecked(final int wanted) {
		return track()
			.filter(t -> tracks.orElseThrow().isChecked(filament, t.frames().get(wanted - 1)))
			.isPresent();
	}

	/**
	 * @return in which frames the filament crosses another one, by that one's number, or itself, by
	 *         its own
	 */
	public synchronized SortedMap<Integer, SortedSet<Integer>> meetings() {
		return meetings;
	}

	private void meet() {
		meetings = track().map(t -> Meetings.of(tracks.orElseThrow(), t)).orElse(new TreeMap<>());
	}

	/** Another result, and where it differs from the one before. */
	final synchronized void show(final Tracks next, final SortedSet<Edits.Place> differing) {
		tracks = Optional.of(next);
		changed = differing;
		if (track().isEmpty() && !next.filaments().isEmpty())
			filament = next.filaments().get(0).id();
		meet();
	}

	/** The same result, of which something else is said that does not change it. */
	final synchronized void saying(final List<Constraint> said) {
		tracks = tracks.map(t -> t.saying(said));
	}

	/** @return the frames in which the last answer shows the filament otherwise than the one before */
	public synchronized SortedSet<Integer> changed() {
		final SortedSet<Integer> frames = new TreeSet<>();
		changed.stream().filter(p -> p.filament() == filament).forEach(p -> frames.add(p.frame()));
		return frames;
	}

	/** When a filament crosses which. */
	private static final class Meetings {

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
}
