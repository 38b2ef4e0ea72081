package io.github.knotresolver.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;

import ij.ImagePlus;
import io.github.knotresolver.imagej.Engine;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.ResultWriter;
import io.github.knotresolver.imagej.RoiConverter;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.io.MeasuredTracks;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.io.RunReport;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
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
		final Map<String, String> texts = GivenOptions.of(spec);
		final RunOptions run = Usage.of(spec, () -> RunOptions.parse(texts));
		final MeasuredTracks result;
		try (ResultFolder folder = Usage.of(spec, () -> ResultFolder.reserve(out,
			ResultKind.RESOLUTION, force, RunIdentity.files(movie, texts)))) {
			final ImagePlus image = Usage.of(spec, this::image);
			final Movie input = Usage.of(spec, () -> ImageMovie.of(image, run.input()));
			final var parameters = Usage.of(spec, () -> run.settings(input, CorrectionsCsv.of(run)));
			final Optional<RunIdentity> identity = RunIdentity.of(ImageFile.of(image), texts,
				progress);
			result = MeasuredTracks.of(
				engine.resolve(input, parameters, progress), progress);
			final RoiConverter rois = RoiConverter.forImage(image, run.input().channel());
			new ResultWriter(result, run.input(), rois, identity).write(folder, plots, progress);
		}
		final PrintWriter stdout = spec.commandLine().getOut();
		RunReport.lines(result).forEach(stdout::println);
		stdout.println("Result: " + out + " (look at montage.png first).");
	}

	private ImagePlus image() {
		if (sample == (movie != null))
			throw new UserException(sample
				? "Either a movie or --sample, but not both."
				: "Name a movie, or add --sample for the one that comes along.");
		return sample ? SampleMovie.open() : ImageFile.open(movie, progress);
	}
}
