package io.github.knotresolver.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.ParametersJson;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.TruthCsv;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.Canvas;
import io.github.knotresolver.simulate.FilamentSimulator;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;
import io.github.knotresolver.simulate.SimulatedMovie;
import io.github.knotresolver.simulate.SimulationParameters;

/**
 * A movie with known truth, from its parameters to its folder.
 *
 * @param parameters what decides the trajectory
 * @param rendering what decides the pictures
 */
public record SimulationRun(SimulationParameters parameters, Rendering rendering) {

	/** The movie's name in the folder. */
	public static final String MOVIE = "movie.tif";

	/**
	 * Checks.
	 *
	 * @param parameters physics of the movie
	 * @param rendering how it is drawn
	 * @throws UserException if a value is out of range, in one sentence
	 */
	public SimulationRun {
		rendering.renderer(parameters.seed());
		rendering.depth();
		Canvas.check(rendering.pixelSize(), rendering.margin());
	}

	/**
	 * @param progress told how far it is; may cancel
	 * @return the movie and its truth
	 */
	public SimulatedMovie run(final Progress progress) {
		final Trajectory trajectory = new FilamentSimulator(parameters).run(progress);
		final Canvas canvas = Canvas.around(trajectory, rendering.pixelSize(), rendering.margin());
		return SimulatedMovie.render(MOVIE, trajectory, canvas,
			rendering.renderer(parameters.seed()), rendering.depth(), progress);
	}

	/** Writes a movie into a file. */
	@FunctionalInterface
	public interface MovieSink {

		/**
		 * @param movie the movie
		 * @param file the file to write
		 * @throws IOException if it cannot be written
		 */
		void write(Movie movie, Path file) throws IOException;
	}

	/**
	 * Writes a complete folder or nothing.
	 *
	 * @param movie what {@link #run(Progress)} gave
	 * @param sink writes the movie itself
	 * @param folder the reserved folder; committed here
	 * @throws IOException if a file cannot be written
	 */
	public void write(final SimulatedMovie movie, final MovieSink sink, final ResultFolder folder)
		throws IOException {
		sink.write(movie.movie(), folder.path().resolve(MOVIE));
		TruthCsv.write(folder.path().resolve(ContoursCsv.FILE), movie.truth());
		ParametersJson.write(folder.path().resolve(ParametersJson.FILE), parameters,
			rendering.settings());
		folder.commit();
	}

	/**
	 * @param movie what {@link #run(Progress)} gave
	 * @return what came of it, in one line
	 */
	public static String report(final SimulatedMovie movie) {
		final long crossing = movie.truth().stream()
			.filter(c -> !Crossings.of(c.resampled(1)).isEmpty()).count();
		return String.format(Locale.ROOT,
			"%d frames of %d x %d pixels, the filament crosses itself in %d of them.",
			movie.movie().size(), movie.movie().width(), movie.movie().height(), crossing);
	}
}
