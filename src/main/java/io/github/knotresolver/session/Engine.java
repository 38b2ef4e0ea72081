package io.github.knotresolver.session;

import java.util.List;

import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** What turns a movie into a result: a session, or what a test puts in its place. */
@FunctionalInterface
public interface Engine {

	/** The program's own. */
	Engine PIPELINE = (movie, parameters, progress) -> new Session(movie, parameters)
		.solve(List.of(), progress);

	/**
	 * @param movie the movie
	 * @param parameters what decides the result
	 * @param progress listens, and may cancel
	 * @return the result
	 * @throws UserException if the movie cannot be used, in one
	 *           sentence
	 * @throws io.github.knotresolver.progress.CancelledException if the user
	 *           asked to stop
	 */
	Tracks resolve(Movie movie, Settings parameters, Progress progress);
}
