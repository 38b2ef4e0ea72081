package io.github.knotresolver.run;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;

/** Where a movie comes from. */
public interface MovieSource {

	/**
	 * Reads the movie. Called once.
	 *
	 * @param options how it is taken from its image
	 * @param progress may cancel
	 * @return the movie
	 * @throws UserException if it cannot be read or used, in one sentence
	 */
	Movie read(InputOptions options, Progress progress);

	/** @return what a person should know of how the movie was read, a sentence each */
	default List<String> notes() {
		return List.of();
	}

	/** @return the movie's file; empty if it has none */
	Optional<Path> file();
}
