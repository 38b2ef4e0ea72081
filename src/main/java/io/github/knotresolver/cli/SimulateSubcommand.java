package io.github.knotresolver.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;

import io.github.knotresolver.imagej.MovieTiff;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.SimulationRun;
import io.github.knotresolver.simulate.SimulatedMovie;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code knotresolver simulate}: a movie with known truth. */
@Command(name = "simulate", mixinStandardHelpOptions = true, sortOptions = false, usageHelpAutoWidth = true, description = "Simulates a clamped filament over motors and writes a movie with its truth: movie.tif, contours.csv, parameters.json.%n")
final class SimulateSubcommand implements Callable<Integer> {

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
		final SimulationRun run = Usage.of(spec,
			() -> new SimulationRun(simulation.parameters(), rendering.rendering()));
		final SimulatedMovie movie;
		try (ResultFolder folder = Usage.of(spec,
			() -> ResultFolder.reserve(out, ResultKind.SIMULATION, force, List.of()))) {
			movie = run.run(progress);
			run.write(movie, MovieTiff::write, folder);
		}
		spec.commandLine().getOut().println(SimulationRun.report(movie));
		spec.commandLine().getOut().println("Movie and truth: " + out);
	}
}
