package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;
import org.scijava.widget.FileWidget;

import io.github.knotresolver.evaluate.Evaluation.FrameScore;
import io.github.knotresolver.evaluate.like.LikeReport;
import io.github.knotresolver.evaluate.like.LikeResult;
import io.github.knotresolver.evaluate.like.LikeStudy;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.imagej.LikeFolder;
import io.github.knotresolver.imagej.plot.ScoreFiles;
import io.github.knotresolver.imagej.plot.ScorePlots;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.io.TruthCsv;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.LikeRun;
import io.github.knotresolver.run.Scores;
import io.github.knotresolver.session.Engine;

/**
 * {@code Evaluate Against Ground Truth...}: a result against the true contours,
 * or against simulated movies that resemble its own.
 */
@Plugin(type = Command.class, label = "Evaluate Against Ground Truth...", attrs = @Attr(name = "no-legacy"))
public class EvaluateCommand extends KnotCommand {

	@Parameter(label = "Truth (contours.csv)", description = "True contours: frame,index,x_px,y_px; fixed end first", required = false, persist = false)
	private File truth;

	@Parameter(label = "Result (folder or contours.csv)", description = "Contours to judge, likewise", required = false, persist = false)
	private File result;

	@Parameter(label = "Like (result folder)", description = "Instead of the two above: movies that resemble this result's are simulated, resolved alike and scored", style = FileWidget.DIRECTORY_STYLE, required = false, persist = false)
	private File like;

	@Parameter(label = "Movies (how many)", description = "To simulate; with Like", min = "1", max = "1000", required = false, persist = false)
	private int movies = LikeStudy.MOVIES;

	@Parameter(label = "Seed", description = "The same seed gives the same scores; with Like", required = false, persist = false)
	private long seed = 1;

	@Parameter(label = "Movie (file)", description = "That the result was made from; with Like; empty for the file that the result tells", required = false, persist = false)
	private File movie;

	@Parameter(label = "Out (CSV; a folder with Like)", description = "Gets the scores of every frame, and figures; empty to write no file", required = false, persist = false)
	private File out;

	@Parameter(label = "Force (replace scores)", description = "Scores, or a folder with Like, that were written earlier", required = false, persist = false)
	private boolean force = false;

	@Parameter(label = "Table", description = "Show the scores of every frame", required = false, persist = false)
	private boolean table = true;

	@Parameter(label = "Plots", description = "Show and write figures: position errors, Dice index, Fréchet distance", required = false, persist = false)
	private boolean plots = true;

	@Override
	void work(final Progress progress) throws IOException {
		if (like == null)
			againstTruth(progress);
		else
			againstLike(progress);
	}

	private void againstTruth(final Progress progress) throws IOException {
		final Path truths = path("truth", truth), results = path("result", result);
		final Scores scores;
		if (out == null)
			scores = Scores.of(truths, results, progress);
		else
			try (ScoreFiles files = ScoreFiles.reserve(out.toPath(), plots, force,
				TruthCsv.files(truths, results))) {
				scores = Scores.of(truths, results, progress);
				files.write(scores, progress).forEach(this::say);
			}
		for (int i = 1; i < scores.filaments().size() && table && isShown(); i++)
			ScorePlots.table(scores.frames().get(i)).show(
				"evaluation-" + MeasuredFilament.number(scores.filaments().get(i).filament()));
		show(scores.frames(), scores.positionErrors());
		scores.lines().forEach(this::say);
	}

	private void againstLike(final Progress progress) throws IOException {
		if (truth != null || result != null)
			throw new UserException(
				"like stands alone: leave truth and result empty, or leave like empty to compare those.");
		final Path original = movie == null ? null : movie.toPath();
		final LikeResult scores;
		if (out == null)
			scores = study(original, progress).run(movies, seed, progress);
		else
			try (ResultFolder folder = ResultFolder.reserve(out.toPath(), ResultKind.STUDY, force,
				LikeRun.files(like.toPath(), original))) {
				final LikeStudy study = study(original, progress);
				scores = study.run(movies, seed, progress);
				LikeFolder.write(study, scores, folder, plots, progress).forEach(this::say);
			}
		show(List.of(scores.movies().get(0).evaluation().frames()), scores.positionErrors());
		LikeReport.lines(scores).forEach(this::say);
	}

	private static boolean isShown() {
		return !GraphicsEnvironment.isHeadless();
	}

	/** Of several filaments, the plots show all frames together. */
	private void show(final List<List<FrameScore>> filaments, final double[] errors) {
		if (!isShown())
			return;
		if (table)
			ScorePlots.table(filaments.get(0)).show("evaluation");
		final List<FrameScore> frames = filaments.stream().flatMap(List::stream).toList();
		if (!plots)
			return;
		if (errors.length > 0)
			ScorePlots.positionErrors(errors).show();
		ScorePlots.dice(frames).show();
		ScorePlots.frechet(frames).show();
	}

	private LikeStudy study(final Path original, final Progress progress) {
		return new LikeStudy(LikeRun.source(like.toPath(), original, ImageSource::of, progress),
			Engine.PIPELINE, progress);
	}

	private static Path path(final String key, final File given) {
		if (given == null)
			throw new UserException(
				key + " is missing; name a contours.csv, or a folder with one.");
		return given.toPath();
	}
}
