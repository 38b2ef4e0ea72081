package io.github.knotresolver.evaluate;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

import io.github.knotresolver.evaluate.SceneEvaluation.FilamentScore;

/** An evaluation in a few lines, for people. */
public final class EvaluationReport {

	private final List<String> lines = new ArrayList<>();

	private EvaluationReport() {
	}

	/**
	 * @param evaluation an evaluation
	 * @return a few lines; figures that there are not are left out
	 */
	public static List<String> lines(final Evaluation evaluation) {
		final EvaluationSummary s = evaluation.summary();
		final EvaluationReport report = new EvaluationReport();
		report.line("frames", "%.0f", s.frames());
		report.line("frames with a contour", "%.0f", s.framesPresent());
		report.line("frames with crossings", "%.0f", s.framesWithCrossings());
		report.line("frames without truth", "%.0f", s.extraResultFrames());
		report.line("resolved (Frechet < 5 px)", "%.1f %%", s.percentResolved());
		report.line("  of frames with crossings", "%.1f %%", s.percentResolvedCrossingFrames());
		report.line("  of frames without", "%.1f %%", s.percentResolvedSimpleFrames());
		report.line("from tip to fixed end", "%.0f frames", s.framesFlipped());
		report.line("Dice index, mean", "%.4f", s.meanDice());
		report.line("  of frames with crossings", "%.4f", s.meanDiceCrossingFrames());
		report.line("Frechet distance, median", "%.3f px", s.medianFrechet());
		report.line("  of frames with a contour", "%.3f px", s.medianFrechetPresent());
		report.line("position error, mean", "%.3f px", s.meanError());
		ErrorHistogram.of(evaluation.positionErrors(), ErrorHistogram.FINE_BIN).gaussian()
			.ifPresent(g -> report.lines.add(String.format(Locale.ROOT,
				"%-28s mean %.3f px, sigma %.3f px", "  Gaussian fit", g.mean(), g.sigma())));
		report.line("truth missed by, mean", "%.3f px", s.meanMiss());
		report.line("length error, median", "%.2f %%", s.medianAbsoluteLengthError());
		s.firstUnresolvedFrame().ifPresent(f -> report.line("first unresolved frame", "%.0f", f));
		return List.copyOf(report.lines);
	}

	/**
	 * @param scene an evaluation of several filaments
	 * @return a few lines; figures that there are not are left out
	 */
	public static List<String> lines(final SceneEvaluation scene) {
		final EvaluationReport report = new EvaluationReport();
		report.line("filaments", "%.0f", scene.filaments().size());
		report.line("filaments of the result", "%.0f", scene.resultFilaments());
		report.line("filament-frames", "%.0f", scene.frames());
		report.line("  with crossings", "%.0f", scene.crossingFrames());
		report.line("resolved (Frechet < 5 px)", "%.2f %%", scene.percentResolved());
		report.line("  of those with crossings", "%.2f %%", scene.percentResolvedCrossing());
		report.line("found, by any filament", "%.2f %%", scene.percentFound());
		report.line("identity switches", "%.0f", scene.switches());
		report.line("false contours", "%.2f %%", scene.percentFalse());
		report.line("  and sure (> 0.9)", "%.2f %%", scene.percentSilent());
		report.line("filaments the right way", "%.0f %%", scene.percentRightWay());
		report.line("position error of resolved", "%.3f px", scene.meanErrorResolved());
		for (final FilamentScore f : scene.filaments())
			report.lines.add(String.format(Locale.ROOT, "  filament %d: %s", f.filament(),
				f.isGiven()
					? String.format(Locale.ROOT, "filament %d of the result%s, resolved %.1f %%",
						f.result().getAsInt(), f.reversed() ? ", reversed" : "",
						f.evaluation().summary().percentResolved())
					: "not found"));
		return List.copyOf(report.lines);
	}

	private void line(final String what, final String format, final double value) {
		if (!Double.isNaN(value))
			lines.add(String.format(Locale.ROOT, "%-28s " + format, what, value));
	}
}
