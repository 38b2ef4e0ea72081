package io.github.knotresolver.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.stream.Stream;

import io.github.knotresolver.imagej.Batch;
import io.github.knotresolver.imagej.BatchWork;
import io.github.knotresolver.io.BatchFolders.Rows;
import io.github.knotresolver.io.BatchList;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.io.BatchSheet;
import io.github.knotresolver.io.MovieFolder;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code knotresolver batch}: many movies, from a sheet or a folder. */
@Command(name = "batch", mixinStandardHelpOptions = true, sortOptions = false, abbreviateSynopsis = true, usageHelpAutoWidth = true, description = "Resolves the movies of a sheet or a folder, as many at a time as threads and memory allow, each into its own result folder. Finished ones are skipped; one that fails is reported and the rest go on. batch.html shows all results.%n")
final class BatchSubcommand implements Callable<Integer> {

	@Spec
	private CommandSpec spec;

	@Parameters(paramLabel = "SHEET", description = "CSV with the columns FileName and FolderPath and any of the options below, or a folder of movies.")
	private Path input;

	@Option(names = "--out", required = true, paramLabel = "DIR", description = "Folder of the result folders; made if absent.")
	private Path out;

	@Option(names = "--force", description = "Do finished rows again.")
	private boolean force;

	@Option(names = "--plots", negatable = true, defaultValue = "true", fallbackValue = "true", description = "Write plots and projections as PNG, or not [on].")
	private boolean plots;

	@Option(names = "--movies", paramLabel = "N", description = "Most movies at a time [as many as threads and memory allow].")
	private Integer movies;

	@Option(names = "--rows", paramLabel = "A-B", description = "Only these rows, counted from 1: one of several processes that share the folder (a cluster); batch-rows/A-B.csv lists them.")
	private String rows;

	@Option(names = "--collect", description = "Resolve nothing: write batch.csv and batch.html of what runs with --rows made.")
	private boolean collect;

	@Option(names = "--plan", description = "Do nothing: print how much memory each row takes, as CSV.")
	private boolean plan;

	private final Engine engine;
	private final Progress progress;

	BatchSubcommand(final Engine engine, final Progress progress) {
		this.engine = engine;
		this.progress = progress;
	}

	@Override
	public Integer call() throws IOException {
		final PrintWriter stdout = spec.commandLine().getOut();
		final PrintWriter stderr = spec.commandLine().getErr();
		final List<BatchOutcome> outcomes;
		try {
			final var texts = GivenOptions.of(spec);
			RunOptions.parse(texts);
			requireOneTask();
			final BatchSheet sheet = MovieFolder.read(input);
			if (!sheet.unknownColumns().isEmpty())
				stderr.println("Columns that mean nothing here: "
					+ String.join(", ", sheet.unknownColumns()) + ".");
			final BatchWork work = new BatchWork(sheet.rows(), out, List.of(input));
			if (plan)
				return print(work, stdout);
			outcomes = outcomes(new Batch(engine, texts, force, plots, Optional.ofNullable(movies)),
				work, o -> (o.status() == Status.FAILED ? stderr : stdout).println(o.line()));
		} catch (final UserException e) {
			throw new ParameterException(spec.commandLine(), e.getMessage(), e);
		}
		final long failed = outcomes.stream().filter(o -> o.status() == Status.FAILED).count();
		stdout.println((outcomes.size() - failed) + " of " + outcomes.size()
			+ " movies have a result."
			+ (rows == null
				? " List: " + out.resolve(BatchList.FILE) + ", page: " + out.resolve(BatchList.PAGE)
				: ""));
		return failed == 0 ? ExitStatus.FINISHED : ExitStatus.FAILED;
	}

	private void requireOneTask() {
		if (Stream.of(rows != null, collect, plan).filter(told -> told).count() > 1)
			throw new UserException(
				"Only one of --rows, --collect and --plan can be told at a time.");
	}

	private List<BatchOutcome> outcomes(final Batch batch, final BatchWork work,
		final Consumer<BatchOutcome> listener) throws IOException {
		if (rows != null)
			return batch.part(work, Rows.parse(rows), listener, progress);
		if (!collect)
			return batch.run(work, listener, progress);
		final List<BatchOutcome> outcomes = batch.collect(work, progress);
		outcomes.stream().filter(o -> o.status() == Status.FAILED).forEach(listener);
		return outcomes;
	}

	private static int print(final BatchWork work, final PrintWriter stdout) {
		stdout.println("row,megabytes,movie");
		work.plan().forEach(p -> stdout.println(
			p.row() + "," + p.megabytes() + ",\"" + p.movie().replace("\"", "\"\"") + "\""));
		return ExitStatus.FINISHED;
	}
}
