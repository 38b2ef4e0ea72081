package io.github.knotresolver.imagej;

import java.util.Optional;

import io.github.knotresolver.image.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.pipeline.FilamentResolver;
import io.github.knotresolver.pipeline.Parameters;
import io.github.knotresolver.pipeline.Region;
import io.github.knotresolver.pipeline.Resolution;
import io.github.knotresolver.progress.Progress;

/** What turns a movie into a result: the pipeline, for those who show it. */
@FunctionalInterface
public interface Engine {

	/** The program's own. */
	Engine PIPELINE = (movie, parameters, progress) -> new FilamentResolver(parameters)
		.resolve(movie, progress);

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
	Resolution resolve(Movie movie, Parameters parameters, Progress progress);

	/**
	 * @param region where to search; empty for everywhere
	 * @return this engine, searching only there; its results are in the whole
	 *         movie's pixels
	 */
	default Engine within(final Optional<Region> region) {
		return region.<Engine>map(r -> new RegionEngine(this, r)).orElse(this);
	}
}
