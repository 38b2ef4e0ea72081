package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;

import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;

import ij.measure.ResultsTable;
import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.EvaluationCsv;
import io.github.knotresolver.io.EvaluationReport;
import io.github.knotresolver.progress.Progress;

/** {@code Evaluate Against Ground Truth...}: a result against the true contours. */
@Plugin(type = Command.class, label = "Evaluate Against Ground Truth...", attrs = @Attr(name = "no-legacy"))
public class EvaluateCommand extends KnotCommand {

	@Parameter(label = "Truth (contours.csv)", description = "True contours: frame,index,x_px,y_px; fixed end first", required = false, persist = false)
	private File truth;

	@Parameter(label = "Result (folder or contours.csv)", description = "Contours to judge, likewise", required = false, persist = false)
	private File result;

	@Parameter(label = "Out (CSV)", description = "Gets the scores of every frame; empty to write no file", required = false, persist = false)
	private File out;

	@Parameter(label = "Table", description = "Show the scores of every frame", required = false, persist = false)
	private boolean table = true;

	@Override
	void work(final Progress progress) throws IOException {
		if (out != null)
			EvaluationCsv.requireWritable(out.toPath());
		final Evaluation evaluation = Evaluation.of(ContoursCsv.read(file("truth", truth).toPath()),
			ContoursCsv.read(file("result", result).toPath()), progress);
		if (out != null)
			EvaluationCsv.write(out.toPath(), evaluation);
		if (table && !GraphicsEnvironment.isHeadless())
			table(evaluation).show("evaluation");
		EvaluationReport.lines(evaluation).forEach(this::say);
	}

	/** A folder stands for the contours in it. */
	private static File file(final String key, final File given) {
		if (given == null)
			throw new IllegalArgumentException(
				key + " is missing; name a contours.csv, or a folder with one.");
		return Files.isDirectory(given.toPath()) ? new File(given, ContoursCsv.FILE) : given;
	}

	private static ResultsTable table(final Evaluation evaluation) {
		final ResultsTable rows = new ResultsTable();
		rows.setNaNEmptyCells(true);
		evaluation.frames().forEach(f -> {
			rows.addRow();
			rows.addValue("frame", f.frame());
			rows.addValue("crossings", f.crossings());
			rows.addValue("Dice", f.score().dice());
			rows.addValue("Frechet distance [px]", f.score().frechet());
			rows.addValue("position error [px]", f.score().error());
		});
		return rows;
	}
}
