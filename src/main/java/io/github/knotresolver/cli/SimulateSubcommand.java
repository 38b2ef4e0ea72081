package io.github.knotresolver.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.imagej.MovieTiff;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.ParametersJson;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.SimulationJson;
import io.github.knotresolver.io.TruthCsv;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.BitDepth;
import io.github.knotresolver.simulate.Canvas;
import io.github.knotresolver.simulate.FilamentSimulator;
import io.github.knotresolver.simulate.FrameRenderer;
import io.github.knotresolver.simulate.SimulatedMovie;
import io.github.knotresolver.simulate.SimulationParameters;
import io.github.knotresolver.simulate.Trajectory;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code knotresolver simulate}: a movie with known truth. */
@Command(name = "simulate", mixinStandardHelpOptions = true, sortOptions = false, usageHelpAutoWidth = true, description = "Simulates a clamped filament over motors and writes a movie with its truth: movie.tif, contours.csv, parameters.json.%n")
final class SimulateSubcommand implements Callable<Integer> {

	/** The movie's name in the folder. */
	static final String MOVIE = "movie.tif";

	@Spec
	private CommandSpec spec;

	@Option(names = "--out", required = true, paramLabel = "DIR", description = "Folder of the movie; made if absent.")
	private Path out;

	@Option(names = "--force", description = "Replace what is already there.")
	private boolean force;

	@Mixin
	private SimulateOptions simulation;

	@Mixin
	private RenderOptions rendering;

	private final Progress progress;

	SimulateSubcommand(final Progress progress) {
		this.progress = progress;
	}

	@Override
	public Integer call() throws IOException {
		simulate();
		return ExitStatus.FINISHED;
	}

	private void simulate() throws IOException {
		final SimulationParameters parameters;
		final FrameRenderer renderer;
		final BitDepth depth;
		try {
			parameters = simulation.parameters();
			renderer = rendering.renderer(simulation.seed());
			depth = rendering.depth();
			Canvas.check(rendering.pixelSize(), rendering.margin());
			ResultFolder.check(out, force);
		} catch (final IllegalArgumentException e) {
			throw new ParameterException(spec.commandLine(), e.getMessage(), e);
		}
		final Trajectory trajectory = new FilamentSimulator(parameters).run(progress);
		final Canvas canvas = Canvas.around(trajectory, rendering.pixelSize(), rendering.margin());
		final SimulatedMovie movie = SimulatedMovie.render(MOVIE, trajectory, canvas, renderer,
			depth, progress);
		write(movie, parameters);
		report(movie);
	}

	private void write(final SimulatedMovie movie, final SimulationParameters parameters)
		throws IOException {
		try (ResultFolder folder = ResultFolder.prepare(out, force)) {
			MovieTiff.write(movie.movie(), folder.path().resolve(MOVIE));
			TruthCsv.write(folder.path().resolve(ContoursCsv.FILE), movie.truth());
			SimulationJson.write(folder.path().resolve(ParametersJson.FILE), parameters,
				rendering.settings());
			folder.commit();
		}
	}

	private void report(final SimulatedMovie movie) {
		final long crossing = movie.truth().stream()
			.filter(c -> !Crossings.of(c.resampled(1)).isEmpty()).count();
		spec.commandLine().getOut().printf(Locale.ROOT,
			"%d frames of %d x %d pixels, the filament crosses itself in %d of them.%nMovie and truth: %s%n",
			movie.movie().size(), movie.movie().width(), movie.movie().height(), crossing, out);
	}
}
