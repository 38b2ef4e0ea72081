package io.github.knotresolver.model;

import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * The result: every filament through every frame of the movie.
 *
 * @param movie the movie, with its calibration
 * @param settings what it was resolved with
 * @param filaments the filaments, rising by their numbers
 * @param notes what a user should know about the run: limits that were hit,
 *          choices that were made; one sentence each
 */
public record Tracks(Movie movie, Settings settings, List<FilamentTrack> filaments,
	List<String> notes) {

	public Tracks {
		Objects.requireNonNull(settings);
		filaments = List.copyOf(filaments);
		notes = List.copyOf(notes);
		for (final FilamentTrack filament : filaments)
			if (filament.frames().size() != movie.size())
				throw new IllegalArgumentException(
					"The movie has " + movie.size() + " frames, but filament " + filament.id()
						+ " has " + filament.frames().size() + ".");
		for (int i = 1; i < filaments.size(); i++)
			if (filaments.get(i).id() <= filaments.get(i - 1).id())
				throw new IllegalArgumentException("Filaments must rise by their numbers, but "
					+ filaments.get(i).id() + " follows " + filaments.get(i - 1).id() + ".");
	}

	/**
	 * The track of a movie with one filament.
	 *
	 * @return the only filament
	 * @throws IllegalStateException if there is none, or more than one
	 */
	public FilamentTrack only() {
		if (filaments.size() != 1)
			throw new IllegalStateException(
				"One filament is expected, but there are " + filaments.size() + ".");
		return filaments.get(0);
	}

	/**
	 * @param said all that a person says about frames, which leaves the result as it is
	 * @return the same with settings that say so
	 */
	public Tracks saying(final List<Constraint> said) {
		return new Tracks(movie, settings.edit().constraints(said).build(), filaments, notes);
	}

	/**
	 * O(n) in the number of constraints.
	 *
	 * @param filament number of a filament
	 * @param found what was found of it in a frame
	 * @return whether a person has found that right: gave it, chose it, or left it as it is
	 */
	public boolean isChecked(final int filament, final Observation found) {
		return found.status() == FrameStatus.CORRECTED
			|| settings.constraints().stream().anyMatch(c -> c.frame() == found.frame()
				&& c.filament() == filament && c.confirms(found.contour()));
	}

	/**
	 * @param first what a user should know before all else
	 * @return the same with these notes before its own
	 */
	public Tracks noted(final List<String> first) {
		return first.isEmpty()
			? this
			: new Tracks(movie, settings, filaments,
				Stream.concat(first.stream(), notes.stream()).toList());
	}

	/** @return how many frames have a contour of any filament */
	public int resolved() {
		int resolved = 0;
		for (int t = 0; t < movie.size(); t++) {
			final int frame = t;
			if (filaments.stream().anyMatch(f -> f.frames().get(frame).contour().isPresent()))
				resolved++;
		}
		return resolved;
	}
}
