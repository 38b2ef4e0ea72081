package io.github.knotresolver.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;

import io.github.knotresolver.evaluate.like.LikeReport;
import io.github.knotresolver.evaluate.like.LikeResult;
import io.github.knotresolver.evaluate.like.LikeStudy;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.imagej.LikeFolder;
import io.github.knotresolver.imagej.plot.ScoreFiles;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.io.TruthCsv;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.LikeRun;
import io.github.knotresolver.run.Scores;
import io.github.knotresolver.session.Engine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code knotresolver evaluate}: a result against the truth, or against its like. */
@Command(name = "evaluate", mixinStandardHelpOptions = true, sortOptions = false, usageHelpAutoWidth = true, customSynopsis = {
	"knotresolver evaluate --truth TRUTH.csv --result CONTOURS.csv [--out FILE.csv] [--force] [--no-plots]",
	"knotresolver evaluate --like RESULT_DIR [--movies N] [--seed N] [--movie FILE] [--out DIR] [--force] [--no-plots]"}, description = "Compares contours with the true ones: Dice index, Frechet distance, position and length errors. Or simulates movies that resemble a result's, resolves them alike and tells how often and how exactly that works.%n")
final class EvaluateSubcommand implements Callable<Integer> {

	@Spec
	private CommandSpec spec;

	@Option(names = "--truth", paramLabel = "TRUTH.csv", description = "True contours: frame,index,x_px,y_px; fixed end first. Or a folder with a contours.csv.")
	private Path truth;

	@Option(names = "--result", paramLabel = "CONTOURS.csv", description = "Contours to judge, likewise.")
	private Path result;

	@Option(names = "--like", paramLabel = "RESULT_DIR", description = "Instead: a folder that 'resolve' wrote; movies like its own are simulated, resolved and scored.")
	private Path like;

	@Option(names = "--movies", paramLabel = "N", description = "Number of simulated movies, 1 to 1000; with --like [10].")
	private Integer movies;

	@Option(names = "--seed", paramLabel = "N", description = "Start of the random numbers; with --like [1].")
	private Long seed;

	@Option(names = "--movie", paramLabel = "FILE", description = "The movie that the result was made from; with --like [the file that the result tells].")
	private Path movie;

	@Option(names = "--out", paramLabel = "FILE.csv|DIR", description = "Write the scores of every frame to this file; with --like, write tables and figures to this folder.")
	private Path out;

	@Option(names = "--plots", negatable = true, defaultValue = "true", fallbackValue = "true", description = "With --out, draw figures, or not [on]; those of FILE.csv lie beside it.")
	private boolean plots;

	@Option(names = "--force", description = "Replace scores, or a folder, that this command wrote earlier.")
	private boolean force;

	private final Engine engine;
	private final Progress progress;

	EvaluateSubcommand(final Engine engine, final Progress progress) {
		this.engine = engine;
		this.progress = progress;
	}

	@Override
	public Integer call() throws IOException {
		check();
		if (like == null)
			againstTruth();
		else
			againstLike();
		return ExitStatus.FINISHED;
	}

	private void check() {
		if (like != null && (truth != null || result != null))
			throw refusal(
				"--like stands alone: leave out --truth and --result, or --like to compare those.");
		if (like == null && (truth == null || result == null))
			throw refusal("Missing " + (truth == null ? "--truth TRUTH.csv" : "")
				+ (truth == null && result == null ? " and " : "")
				+ (result == null ? "--result CONTOURS.csv" : "")
				+ "; or give --like RESULT_DIR alone.");
		if (like == null && (movies != null || seed != null || movie != null))
			throw refusal("--movies, --seed and --movie go with --like RESULT_DIR only.");
	}

	private ParameterException refusal(final String sentence) {
		return new ParameterException(spec.commandLine(), sentence, new UserException(sentence));
	}

	private void againstTruth() throws IOException {
		if (out == null) {
			print(scores().lines());
			return;
		}
		final Scores scores;
		try (ScoreFiles files = Usage.of(spec,
			() -> ScoreFiles.reserve(out, plots, force, TruthCsv.files(truth, result)))) {
			scores = scores();
			files.write(scores, progress).forEach(spec.commandLine().getErr()::println);
		}
		print(scores.lines());
	}

	private Scores scores() throws IOException {
		return Usage.of(spec, () -> Scores.of(truth, result, progress));
	}

	private void againstLike() throws IOException {
		final int count = movies == null ? LikeStudy.MOVIES : movies;
		Usage.of(spec, () -> {
			LikeStudy.check(count);
			return count;
		});
		if (out == null) {
			print(LikeReport.lines(scores(study(), count)));
			return;
		}
		final LikeResult scores;
		try (ResultFolder folder = Usage.of(spec,
			() -> ResultFolder.reserve(out, ResultKind.STUDY, force, LikeRun.files(like, movie)))) {
			final LikeStudy study = study();
			scores = scores(study, count);
			LikeFolder.write(study, scores, folder, plots, progress)
				.forEach(spec.commandLine().getErr()::println);
		}
		print(LikeReport.lines(scores));
		spec.commandLine().getOut().println("Written to " + out + ".");
	}

	private LikeStudy study() throws IOException {
		return Usage.of(spec,
			() -> new LikeStudy(LikeRun.source(like, movie, ImageSource::of, progress), engine,
				progress));
	}

	private LikeResult scores(final LikeStudy study, final int count) {
		return study.run(count, seed == null ? 1 : seed, progress);
	}

	private void print(final List<String> lines) {
		lines.forEach(spec.commandLine().getOut()::println);
	}
}
