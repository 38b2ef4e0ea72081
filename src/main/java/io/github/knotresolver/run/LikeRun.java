package io.github.knotresolver.run;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;

import io.github.knotresolver.evaluate.like.LikeSource;
import io.github.knotresolver.io.ResolvedRun;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** From a user's result folder to the study of movies like it. */
public final class LikeRun {

	private LikeRun() {
	}

	/**
	 * @param folder a result folder
	 * @param movie the movie that it was made from; null for the file that the
	 *          result tells
	 * @param sources opens a movie's file
	 * @param progress may cancel
	 * @return the result and its movie
	 * @throws UserException if they cannot be read or do not belong
	 *           together, in one sentence
	 */
	public static LikeSource source(final Path folder, final Path movie,
		final Function<Path, MovieSource> sources, final Progress progress) {
		final ResolvedRun run = ResolvedRun.read(folder);
		final Movie opened = open(run, sources.apply(run.movieFile(movie)), progress);
		return new LikeSource(opened, run.contours().contours(), run.options().parameters(opened));
	}

	/**
	 * @param folder a result folder
	 * @param movie the movie that it was made from; null for the file that the
	 *          result tells
	 * @return the files and folders that are read
	 * @throws UserException if the folder is none, or the movie is gone, in
	 *           one sentence
	 */
	public static List<Path> files(final Path folder, final Path movie) {
		return List.of(folder, ResolvedRun.read(folder).movieFile(movie));
	}

	private static Movie open(final ResolvedRun run, final MovieSource source,
		final Progress progress) {
		try {
			return source.read(run.options().input(), progress);
		} catch (final UserException e) {
			throw new UserException("movie cannot be used: " + e.getMessage(), e);
		}
	}
}
