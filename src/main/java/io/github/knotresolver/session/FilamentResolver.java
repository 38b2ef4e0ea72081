package io.github.knotresolver.session;

import java.util.List;

import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** The facade for those who ask once: a {@link Session} with one answer. */
public final class FilamentResolver {

	private final Settings settings;

	/**
	 * @param settings everything that decides the result
	 */
	public FilamentResolver(final Settings settings) {
		this.settings = settings;
	}

	/**
	 * Resolves a movie. The movie is only read.
	 *
	 * @param movie the movie
	 * @param progress told how far the work is, and asked whether to stop
	 * @return one row for every frame of the movie and every filament
	 * @throws UserException if the movie or the settings do not fit
	 *           together, or no filament was found; the message says what to do
	 * @throws io.github.knotresolver.progress.CancelledException if the user asked to
	 *           stop
	 */
	public Tracks resolve(final Movie movie, final Progress progress) {
		return new Session(movie, settings).solve(List.of(), progress);
	}
}
