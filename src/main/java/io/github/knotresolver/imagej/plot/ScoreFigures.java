package io.github.knotresolver.imagej.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.geom.Ellipse2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

import org.apache.commons.math3.stat.StatUtils;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.plot.DatasetRenderingOrder;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.StandardXYBarPainter;
import org.jfree.chart.renderer.xy.XYBarRenderer;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.data.xy.XYBarDataset;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

import io.github.knotresolver.evaluate.CurveScore;
import io.github.knotresolver.evaluate.ErrorHistogram;
import io.github.knotresolver.evaluate.Evaluation.FrameScore;
import io.github.knotresolver.progress.Progress;

/**
 * The figures of an evaluation: histogram of the position errors with the
 * Gaussian that fits it, Dice index and Frechet distance of every frame.
 */
public final class ScoreFigures {

	private static final String POSITION_ERROR = "position_error", DICE = "dice",
		FRECHET = "frechet";
	private static final double DOT = 5;
	private static final int CURVE_POINTS = 300;

	private ScoreFigures() {
	}

	/**
	 * @param prefix what their names begin with; may be empty
	 * @return the names of all files that {@link #write} may make
	 */
	public static List<String> files(final String prefix) {
		return Stream.of(POSITION_ERROR, DICE, FRECHET)
			.flatMap(n -> Stream.of(prefix + n + ".png", prefix + n + ".svg")).toList();
	}

	/**
	 * The figures as charts, by file name without ending: {@code position_error,
	 * dice, frechet}. The first is left out if no frame has a contour.
	 *
	 * @param movies the frames of one movie, or of several
	 * @param errors their position errors in pixels
	 * @return the charts, in a fixed order
	 */
	public static Map<String, JFreeChart> charts(final List<List<FrameScore>> movies,
		final double[] errors) {
		final Map<String, JFreeChart> charts = new LinkedHashMap<>();
		if (errors.length > 0)
			charts.put(POSITION_ERROR, histogram(errors));
		final JFreeChart dice = perFrame(movies, "Dice index", "", CurveScore::dice);
		final NumberAxis share = (NumberAxis) dice.getXYPlot().getRangeAxis();
		share.setRange(0, 1.02);
		share.setTickUnit(new NumberTickUnit(0.2));
		charts.put(DICE, dice);
		final JFreeChart frechet = perFrame(movies, "Fréchet distance", "px", CurveScore::frechet);
		final ValueMarker limit = new ValueMarker(CurveScore.RESOLVED_BELOW, ChartStyle.ACCENT,
			new BasicStroke(1.5f));
		frechet.getXYPlot().addRangeMarker(limit);
		includeZero(frechet);
		charts.put(FRECHET, frechet);
		return charts;
	}

	/**
	 * Writes every chart as PNG and SVG. Works without a display.
	 *
	 * @param folder an existing folder
	 * @param prefix what their names begin with; may be empty
	 * @param movies the frames of one movie, or of several
	 * @param errors their position errors in pixels
	 * @param progress may cancel
	 * @return what was left out and why, a sentence or two each
	 * @throws IOException if a file cannot be written
	 */
	public static List<String> write(final Path folder, final String prefix,
		final List<List<FrameScore>> movies, final double[] errors, final Progress progress)
		throws IOException {
		final Pictures pictures = new Pictures(folder);
		for (final Map.Entry<String, JFreeChart> chart : charts(movies, errors).entrySet()) {
			progress.checkCancelled();
			Figures.write(pictures, prefix + chart.getKey(), chart.getValue());
		}
		return pictures.notes();
	}

	private static JFreeChart histogram(final double[] errors) {
		final ErrorHistogram histogram = ErrorHistogram.of(errors, ErrorHistogram.FINE_BIN);
		final double most = Range.of(errors);
		final double[] density = histogram.density();
		final XYSeries bars = new XYSeries("measured");
		for (int i = 0; i < density.length && i * histogram.binWidth() < most; i++)
			bars.add((i + 0.5) * histogram.binWidth(), density[i]);
		final NumberAxis x = ChartStyle.axis(Range.label(errors, most), "px");
		final NumberAxis y = ChartStyle.axis("Probability density", "1/px");
		y.setAutoRangeIncludesZero(true);
		final XYPlot plot = new XYPlot(
			new XYBarDataset(new XYSeriesCollection(bars), histogram.binWidth()), x, y, bars());
		histogram.gaussian().ifPresent(g -> {
			final XYSeries curve = new XYSeries("Gaussian");
			for (int i = 0; i <= CURVE_POINTS; i++)
				curve.add(most * i / CURVE_POINTS, g.at(most * i / CURVE_POINTS));
			plot.setDataset(1, new XYSeriesCollection(curve));
			plot.setRenderer(1, line());
		});
		plot.setDatasetRenderingOrder(DatasetRenderingOrder.FORWARD);
		x.setRange(0, most);
		x.setTickUnit(new NumberTickUnit(Range.tick(most)));
		return ChartStyle.chart(plot);
	}

	private static XYBarRenderer bars() {
		final XYBarRenderer bars = new XYBarRenderer();
		bars.setBarPainter(new StandardXYBarPainter());
		bars.setShadowVisible(false);
		bars.setDrawBarOutline(true);
		bars.setSeriesOutlinePaint(0, Color.WHITE);
		bars.setSeriesPaint(0, ChartStyle.LINE);
		return bars;
	}

	private static XYLineAndShapeRenderer line() {
		final XYLineAndShapeRenderer line = new XYLineAndShapeRenderer(true, false);
		line.setSeriesPaint(0, ChartStyle.ACCENT);
		line.setSeriesStroke(0, new BasicStroke(2.5f));
		return line;
	}

	/** Dots, one series a movie; a frame without a contour has none. */
	private static JFreeChart perFrame(final List<List<FrameScore>> movies, final String label,
		final String unit, final ToDoubleFunction<CurveScore> figure) {
		final XYSeriesCollection dots = new XYSeriesCollection();
		final XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(movies.size() == 1,
			true);
		for (int m = 0; m < movies.size(); m++) {
			final XYSeries series = new XYSeries(m);
			for (final FrameScore f : movies.get(m)) {
				final double value = figure.applyAsDouble(f.score());
				series.add(f.frame(), Double.isFinite(value) ? (Double) value : null);
			}
			dots.addSeries(series);
			renderer.setSeriesPaint(m, ChartStyle.LINE);
			renderer.setSeriesStroke(m, new BasicStroke(1.2f));
			renderer.setSeriesShape(m, new Ellipse2D.Double(-DOT / 2, -DOT / 2, DOT, DOT));
		}
		final NumberAxis x = ChartStyle.axis("Frame", ""), y = ChartStyle.axis(label, unit);
		x.setStandardTickUnits(NumberAxis.createIntegerTickUnits());
		return ChartStyle.chart(new XYPlot(dots, x, y, renderer));
	}

	/** From 0 to a little more than the largest value, and past the limit. */
	private static void includeZero(final JFreeChart chart) {
		final NumberAxis axis = (NumberAxis) chart.getXYPlot().getRangeAxis();
		final double most = chart.getXYPlot().getDataRange(axis) == null
			? 0
			: chart.getXYPlot().getDataRange(axis).getUpperBound();
		axis.setRange(0, 1.05 * Math.max(CurveScore.RESOLVED_BELOW + 1, most));
	}

	/** How far a histogram of position errors goes, so that a few wrong frames do not squash it. */
	static final class Range {

		private static final double LEAST = 1, MEDIANS = 8;

		private Range() {
		}

		/**
		 * @param errors at least one, in pixels
		 * @return the end of the axis in pixels
		 */
		static double of(final double[] errors) {
			final double most = Math.max(LEAST, MEDIANS * StatUtils.percentile(errors, 50));
			return Math.ceil(most * 2) / 2;
		}

		/**
		 * @param most the end of the axis in pixels
		 * @return the distance of its ticks: some ten of 0.1, 0.2, 0.5, 1, 2, 5, ...
		 */
		static double tick(final double most) {
			double tick = 0.1;
			for (int i = 0; tick * 12 < most; i++)
				tick *= i % 3 == 1 ? 2.5 : 2;
			return tick;
		}

		/**
		 * @param errors at least one, in pixels
		 * @param most the end of the axis
		 * @return the axis' label; it tells how many errors are beyond its end
		 */
		static String label(final double[] errors, final double most) {
			final double beyond = 100.0 * Arrays.stream(errors).filter(e -> e > most).count()
				/ errors.length;
			return beyond == 0
				? "Position error"
				: String.format(Locale.ROOT, "Position error (%.2g %% beyond)", beyond);
		}
	}
}
