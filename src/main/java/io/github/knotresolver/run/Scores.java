package io.github.knotresolver.run;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;

import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.evaluate.Evaluation.FrameScore;
import io.github.knotresolver.evaluate.EvaluationReport;
import io.github.knotresolver.evaluate.SceneEvaluation;
import io.github.knotresolver.evaluate.SceneEvaluation.FilamentScore;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.FramesCsv;
import io.github.knotresolver.io.TruthCsv;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * A result against the truth, from their files: of one filament, or of several.
 *
 * @param filaments the scores of the true filaments
 * @param positionErrors of all points of the result, in pixels
 * @param lines all in a few lines, for people
 */
public record Scores(List<FilamentScore> filaments, double[] positionErrors, List<String> lines) {

	public Scores {
		filaments = List.copyOf(filaments);
		lines = List.copyOf(lines);
	}

	/**
	 * @param truth a file with the true contours, or a folder with a {@code contours.csv}
	 * @param result the contours to judge, likewise; {@code frames.csv} beside it tells
	 *          their confidence
	 * @param progress may cancel
	 * @return the scores
	 * @throws UserException if the files cannot be used, in one sentence
	 */
	public static Scores of(final Path truth, final Path result, final Progress progress) {
		final SortedMap<Integer, SortedMap<Integer, Polyline>> truths = TruthCsv
			.readFilaments("truth", truth), results = TruthCsv.readFilaments("result", result);
		if (truths.size() <= 1 && results.size() <= 1)
			return of(Evaluation.of(only(truths), only(results), progress));
		final Path frames = Files.isDirectory(result)
			? result.resolve(FramesCsv.FILE)
			: result.toAbsolutePath().resolveSibling(FramesCsv.FILE);
		final SceneEvaluation scene = SceneEvaluation.of(truths, results,
			FramesCsv.confidences(frames), progress);
		return new Scores(scene.filaments(), scene.positionErrors(), EvaluationReport.lines(scene));
	}

	private static Scores of(final Evaluation evaluation) {
		return new Scores(List.of(new FilamentScore(1, OptionalInt.of(1), false, evaluation)),
			evaluation.positionErrors(), EvaluationReport.lines(evaluation));
	}

	private static SortedMap<Integer, Polyline> only(
		final SortedMap<Integer, SortedMap<Integer, Polyline>> filaments) {
		return filaments.isEmpty() ? new TreeMap<>() : filaments.get(filaments.firstKey());
	}

	/** @return the frames' scores, filament by filament */
	public List<List<FrameScore>> frames() {
		return filaments.stream().map(f -> f.evaluation().frames()).toList();
	}

	@Override
	public double[] positionErrors() {
		return positionErrors.clone();
	}
}
