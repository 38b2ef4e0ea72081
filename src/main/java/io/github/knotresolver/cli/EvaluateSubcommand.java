package io.github.knotresolver.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.SortedMap;
import java.util.concurrent.Callable;

import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.EvaluationCsv;
import io.github.knotresolver.io.EvaluationReport;
import io.github.knotresolver.progress.Progress;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code knotresolver evaluate}: a result against the truth. */
@Command(name = "evaluate", mixinStandardHelpOptions = true, sortOptions = false, usageHelpAutoWidth = true, description = "Compares contours with the true ones: Dice index, Frechet distance, position and length errors.%n")
final class EvaluateSubcommand implements Callable<Integer> {

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
		EvaluationReport.lines(evaluation).forEach(spec.commandLine().getOut()::println);
		return ExitStatus.FINISHED;
	}

	private Evaluation evaluate() {
		try {
			final SortedMap<Integer, Polyline> expected = ContoursCsv.read(truth);
			final SortedMap<Integer, Polyline> contours = ContoursCsv.read(result);
			if (out != null)
				EvaluationCsv.requireWritable(out);
			return Evaluation.of(expected, contours, progress);
		} catch (final IllegalArgumentException e) {
			throw new ParameterException(spec.commandLine(), e.getMessage(), e);
		}
	}
}
