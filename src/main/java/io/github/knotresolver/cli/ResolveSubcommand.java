package io.github.knotresolver.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.concurrent.Callable;

import io.github.knotresolver.imagej.FolderSink;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.FinishedRun;
import io.github.knotresolver.run.ResolveRun;
import io.github.knotresolver.session.Engine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code knotresolver resolve}: from a movie to a result folder. */
@Command(name = "resolve", mixinStandardHelpOptions = true, sortOptions = false, abbreviateSynopsis = true, usageHelpAutoWidth = true, description = "Finds one ordered contour per frame of a filament that crosses itself.%n")
final class ResolveSubcommand implements Callable<Integer> {

	@Spec
	private CommandSpec spec;

	@Parameters(arity = "0..1", paramLabel = "MOVIE", description = "TIFF stack or another movie that ImageJ reads.")
	private Path movie;

	@Option(names = "--sample", description = "Resolve the sample movie that comes with the program.")
	private boolean sample;

	@Option(names = "--out", required = true, paramLabel = "DIR", description = "Folder of the result; made if absent.")
	private Path out;

	@Option(names = "--force", description = "Replace a result that is already there.")
	private boolean force;

	@Option(names = "--plots", negatable = true, defaultValue = "true", fallbackValue = "true", description = "Write plots and projections as PNG, or not [on].")
	private boolean plots;

	private final Engine engine;
	private final Progress progress;

	ResolveSubcommand(final Engine engine, final Progress progress) {
		this.engine = engine;
		this.progress = progress;
	}

	@Override
	public Integer call() throws IOException {
		resolve();
		return ExitStatus.FINISHED;
	}

	private void resolve() throws IOException {
		final ResolveRun run = Usage.of(spec, () -> ResolveRun.of(GivenOptions.of(spec)));
		final ImageSource source = Usage.of(spec, this::source);
		final FinishedRun outcome;
		try (ResultFolder folder = Usage.of(spec,
			() -> ResultFolder.reserve(out, ResultKind.RESOLVED_MOVIE, force, run.files(source)))) {
			final ResolveRun.Work work = Usage.of(spec, () -> run.read(source, progress));
			outcome = work.resolve(engine, new FolderSink(folder, source, plots), progress);
		}
		final PrintWriter stdout = spec.commandLine().getOut();
		outcome.report().forEach(stdout::println);
		stdout.println("Result: " + out + " (look at montage.png first).");
	}

	private ImageSource source() {
		if (sample == (movie != null))
			throw new UserException(sample
				? "Either a movie or --sample, but not both."
				: "Name a movie, or add --sample for the one that comes along.");
		return sample ? ImageSource.of(SampleMovie.open()) : ImageSource.of(movie);
	}
}
