package io.github.knotresolver.imagej.plot;

import java.awt.BasicStroke;
import java.awt.geom.Ellipse2D;

import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.IntervalMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.DeviationRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.data.xy.YIntervalSeries;
import org.jfree.data.xy.YIntervalSeriesCollection;

import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;

/**
 * A quantity over time, with a band of one standard error on both sides. Frames
 * without a contour are gaps with a grey background.
 */
final class SeriesChart {

	private static final float BAND = 0.25f;
	private static final double DOT = 4;

	private SeriesChart() {
	}

	/** @return the chart of a quantity */
	static JFreeChart of(final MovieMeasurements m, final Quantity quantity) {
		final double[] time = m.times();
		final NumberAxis x = ChartStyle.axis("Time", m.calibration().timeUnit());
		final NumberAxis y = ChartStyle.axis(quantity.label(), m.unit(quantity));
		final YIntervalSeriesCollection runs = runs(time, m.series(quantity), m.errors(quantity));
		final XYPlot plot = new XYPlot(runs, x, y, renderer(runs.getSeriesCount()));
		final JFreeChart chart = ChartStyle.chart(plot);
		final double half = m.calibration().frameInterval() / 2;
		x.setRange(-half, time[time.length - 1] + half);
		m.frames().stream().filter(f -> !f.isMeasured())
			.forEach(f -> plot.addDomainMarker(new IntervalMarker(time[f.frame() - 1] - half,
				time[f.frame() - 1] + half, ColourMap.MISSING), Layer.BACKGROUND));
		return chart;
	}

	/** One series for each run of frames that are there. */
	private static YIntervalSeriesCollection runs(final double[] time, final double[] values,
		final double[] errors) {
		final YIntervalSeriesCollection runs = new YIntervalSeriesCollection();
		YIntervalSeries run = null;
		for (int i = 0; i < values.length; i++) {
			if (Double.isNaN(values[i])) {
				run = null;
				continue;
			}
			if (run == null) {
				run = new YIntervalSeries(runs.getSeriesCount());
				runs.addSeries(run);
			}
			final double e = Double.isNaN(errors[i]) ? 0 : errors[i];
			run.add(time[i], values[i], values[i] - e, values[i] + e);
		}
		return runs;
	}

	private static DeviationRenderer renderer(final int series) {
		final DeviationRenderer renderer = new DeviationRenderer(true, true);
		renderer.setAlpha(BAND);
		for (int i = 0; i < series; i++) {
			renderer.setSeriesPaint(i, ChartStyle.LINE);
			renderer.setSeriesFillPaint(i, ChartStyle.LINE);
			renderer.setSeriesStroke(i, new BasicStroke(1.8f));
			renderer.setSeriesShape(i, new Ellipse2D.Double(-DOT / 2, -DOT / 2, DOT, DOT));
		}
		return renderer;
	}
}
