package io.github.knotresolver.imagej.plot;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;

import ij.gui.Plot;
import ij.measure.ResultsTable;
import io.github.knotresolver.evaluate.CurveScore;
import io.github.knotresolver.evaluate.ErrorHistogram;
import io.github.knotresolver.evaluate.Evaluation.FrameScore;

/**
 * An evaluation as ImageJ's own plots, which users restyle, zoom and list as
 * tables, and as one table with a row a frame.
 */
public final class ScorePlots {

	private static final int CURVE_POINTS = 300;

	private ScorePlots() {
	}

	/**
	 * @param errors position errors in pixels, at least one
	 * @return their histogram with the Gaussian that fits it
	 */
	public static Plot positionErrors(final double[] errors) {
		final ErrorHistogram histogram = ErrorHistogram.of(errors, ErrorHistogram.FINE_BIN);
		final double most = ScoreFigures.Range.of(errors);
		final double[] density = histogram.density();
		final double[] at = new double[density.length];
		Arrays.setAll(at, i -> (i + 0.5) * histogram.binWidth());
		final Plot plot = new Plot("evaluation-position-error",
			ChartStyle.label(ScoreFigures.Range.label(errors, most), "px"),
			ChartStyle.label("Probability density", "1/px"));
		plot.setColor(ChartStyle.LINE, ChartStyle.LINE);
		plot.add("separated bar", at, density);
		double highest = Arrays.stream(density).max().orElse(1);
		if (histogram.gaussian().isPresent()) {
			final ErrorHistogram.Gaussian g = histogram.gaussian().get();
			final double[] x = new double[CURVE_POINTS + 1], y = new double[CURVE_POINTS + 1];
			Arrays.setAll(x, i -> most * i / CURVE_POINTS);
			Arrays.setAll(y, i -> g.at(x[i]));
			plot.setColor(ChartStyle.ACCENT);
			plot.setLineWidth(2);
			plot.add("line", x, y);
			highest = Math.max(highest, Arrays.stream(y).max().orElse(0));
		}
		plot.setLimits(0, most, 0, 1.05 * highest);
		return plot;
	}

	/**
	 * @param frames the scores
	 * @return the Dice index of every frame
	 */
	public static Plot dice(final List<FrameScore> frames) {
		final Plot plot = perFrame("evaluation-dice", "Dice index", frames, CurveScore::dice);
		plot.setLimits(1, Math.max(2, frames.get(frames.size() - 1).frame()), 0, 1.02);
		return plot;
	}

	/**
	 * @param frames the scores
	 * @return the Frechet distance of every frame; frames without a contour are
	 *         gaps
	 */
	public static Plot frechet(final List<FrameScore> frames) {
		final Plot plot = perFrame("evaluation-frechet", ChartStyle.label("Fréchet distance", "px"),
			frames, CurveScore::frechet);
		plot.setLimits(Double.NaN, Double.NaN, 0, Double.NaN);
		return plot;
	}

	private static Plot perFrame(final String title, final String label,
		final List<FrameScore> frames, final ToDoubleFunction<CurveScore> figure) {
		final Plot plot = new Plot(title, "Frame", label);
		plot.setColor(ChartStyle.LINE);
		plot.add("connected", frames.stream().mapToDouble(FrameScore::frame).toArray(),
			frames.stream().map(FrameScore::score).mapToDouble(figure)
				.map(v -> Double.isFinite(v) ? v : Double.NaN).toArray());
		return plot;
	}

	/**
	 * @param frames the scores
	 * @return one row a frame; empty cells where a frame has no contour
	 */
	public static ResultsTable table(final List<FrameScore> frames) {
		final ResultsTable rows = new ResultsTable();
		rows.setNaNEmptyCells(true);
		for (final FrameScore f : frames) {
			rows.addRow();
			rows.addValue("frame", f.frame());
			rows.addValue("crossings", f.crossings());
			rows.addValue("Dice", f.score().dice());
			rows.addValue("Frechet distance [px]", finite(f.score().frechet()));
			rows.addValue("position error [px]", finite(f.score().error()));
			rows.addValue("length error [%]", f.present() ? f.score().lengthError() : Double.NaN);
		}
		return rows;
	}

	private static double finite(final double value) {
		return Double.isFinite(value) ? value : Double.NaN;
	}
}
