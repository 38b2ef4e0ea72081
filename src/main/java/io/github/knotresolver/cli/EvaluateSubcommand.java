package io.github.knotresolver.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.SortedMap;
import java.util.concurrent.Callable;

import io.github.knotresolver.evaluate.ErrorHistogram;
import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.evaluate.EvaluationSummary;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.EvaluationCsv;
import io.github.knotresolver.progress.Progress;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code knotresolver evaluate}: a result against the truth. */
@Command(name = "evaluate", mixinStandardHelpOptions = true, sortOptions = false, usageHelpAutoWidth = true, description = "Compares contours with the true ones: Dice index, Frechet distance, position and length errors.%n")
final class EvaluateSubcommand implements Callable<Integer> {

	/** Width of a bin of the position errors, in pixels. */
	private static final double BIN = 0.1;

	@Spec
	private CommandSpec spec;

	@Option(names = "--truth", required = true, paramLabel = "TRUTH.csv", description = "True contours: frame,index,x_px,y_px; fixed end first.")
	private Path truth;

	@Option(names = "--result", required = true, paramLabel = "CONTOURS.csv", description = "Contours to judge, likewise.")
	private Path result;

	@Option(names = "--out", paramLabel = "FILE.csv", description = "Write the scores of every frame to this file.")
	private Path out;

	private final Progress progress;

	EvaluateSubcommand(final Progress progress) {
		this.progress = progress;
	}

	@Override
	public Integer call() throws IOException {
		final Evaluation evaluation = evaluate();
		if (out != null)
			EvaluationCsv.write(out, evaluation);
		report(evaluation, spec.commandLine().getOut());
		return ExitStatus.FINISHED;
	}

	private Evaluation evaluate() {
		try {
			final SortedMap<Integer, Polyline> expected = ContoursCsv.read(truth);
			final SortedMap<Integer, Polyline> contours = ContoursCsv.read(result);
			requireWritable();
			return Evaluation.of(expected, contours, progress);
		} catch (final IllegalArgumentException e) {
			throw new ParameterException(spec.commandLine(), e.getMessage(), e);
		}
	}

	private void requireWritable() {
		if (out == null)
			return;
		final Path folder = out.toAbsolutePath().normalize().getParent();
		if (folder == null || Files.isDirectory(out) || !Files.isDirectory(folder)
			|| !Files.isWritable(Files.exists(out) ? out : folder))
			throw new IllegalArgumentException(
				"The scores cannot be written to " + out + "; choose a file in a writable folder.");
	}

	private static void report(final Evaluation evaluation, final PrintWriter out) {
		final EvaluationSummary s = evaluation.summary();
		line(out, "frames", "%.0f", s.frames());
		line(out, "frames with a contour", "%.0f", s.framesPresent());
		line(out, "frames with crossings", "%.0f", s.framesWithCrossings());
		line(out, "frames without truth", "%.0f", s.extraResultFrames());
		line(out, "resolved (Frechet < 5 px)", "%.1f %%", s.percentResolved());
		line(out, "  of frames with crossings", "%.1f %%", s.percentResolvedCrossingFrames());
		line(out, "  of frames without", "%.1f %%", s.percentResolvedSimpleFrames());
		line(out, "from tip to fixed end", "%.0f frames", s.framesFlipped());
		line(out, "Dice index, mean", "%.4f", s.meanDice());
		line(out, "  of frames with crossings", "%.4f", s.meanDiceCrossingFrames());
		line(out, "Frechet distance, median", "%.3f px", s.medianFrechet());
		line(out, "  of frames with a contour", "%.3f px", s.medianFrechetPresent());
		line(out, "position error, mean", "%.3f px", s.meanError());
		ErrorHistogram.of(evaluation.positionErrors(), BIN).gaussian()
			.ifPresent(g -> out.printf(Locale.ROOT, "%-28s mean %.3f px, sigma %.3f px%n",
				"  Gaussian fit", g.mean(), g.sigma()));
		line(out, "truth missed by, mean", "%.3f px", s.meanMiss());
		line(out, "length error, median", "%.2f %%", s.medianAbsoluteLengthError());
		s.firstUnresolvedFrame().ifPresent(f -> line(out, "first unresolved frame", "%.0f", f));
	}

	private static void line(final PrintWriter out, final String what, final String format,
		final double value) {
		if (Double.isNaN(value))
			return;
		out.printf(Locale.ROOT, "%-28s " + format + "%n", what, value);
	}
}
