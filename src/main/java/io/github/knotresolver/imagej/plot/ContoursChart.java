package io.github.knotresolver.imagej.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Paint;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;

import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

import io.github.knotresolver.measure.ContourGeometry;
import io.github.knotresolver.measure.FrameMeasurement;
import io.github.knotresolver.measure.MovieMeasurements;

/**
 * All contours of a movie in one picture, in the image's own axes, with colour
 * along the length.
 */
final class ContoursChart {

	/** Of longer movies, evenly chosen frames; of longer contours, points. */
	private static final int MOST_FRAMES = 150, MOST_POINTS = 80;
	private static final float LINE = 1.5f;
	private static final double MARGIN = 0.05;

	private ContoursChart() {
	}

	/** @return the chart */
	static JFreeChart of(final MovieMeasurements m) {
		final XYSeriesCollection contours = new XYSeriesCollection();
		final List<FrameMeasurement> shown = shown(m);
		double longest = 0;
		for (final FrameMeasurement frame : shown) {
			final ContourGeometry g = frame.geometry().orElseThrow();
			longest = Math.max(longest, g.length());
			contours.addSeries(series(frame.frame(), g));
		}
		final ColourMap colours = ColourMap.rising(0, longest);
		final NumberAxis x = ChartStyle.axis("x", m.calibration().unit());
		final NumberAxis y = ChartStyle.axis("y", m.calibration().unit());
		y.setInverted(true);
		final XYPlot plot = new XYPlot(contours, x, y, new AlongLength(contours, colours));
		final JFreeChart chart = ChartStyle.chart(plot);
		final double[] view = view(shown.stream().map(f -> f.geometry().orElseThrow()).toList());
		x.setRange(view[0], view[1]);
		y.setRange(view[2], view[3]);
		ChartStyle.addColourBar(chart, colours,
			ChartStyle.axis("Arc length from the fixed end", m.calibration().unit()));
		return chart;
	}

	/** Evenly chosen frames of a long movie. */
	static List<FrameMeasurement> shown(final MovieMeasurements m) {
		final List<FrameMeasurement> measured = m.measured();
		final int stride = 1 + (measured.size() - 1) / MOST_FRAMES;
		return IntStream.range(0, measured.size()).filter(i -> i % stride == 0)
			.mapToObj(measured::get).toList();
	}

	/**
	 * The ranges of x and y: {left, right, top, bottom}. Both have the same extent,
	 * so that a square chart shows true shapes.
	 */
	static double[] view(final List<ContourGeometry> contours) {
		final DoubleSummaryStatistics x = contours.stream()
			.flatMapToDouble(g -> Arrays.stream(g.x())).summaryStatistics();
		final DoubleSummaryStatistics y = contours.stream()
			.flatMapToDouble(g -> Arrays.stream(g.y())).summaryStatistics();
		final double half = Math.max(x.getMax() - x.getMin(), y.getMax() - y.getMin())
			* (0.5 + MARGIN);
		final double middleX = (x.getMin() + x.getMax()) / 2,
			middleY = (y.getMin() + y.getMax()) / 2;
		return new double[]{middleX - half, middleX + half, middleY - half, middleY + half};
	}

	private static XYSeries series(final int frame, final ContourGeometry g) {
		final XYSeries series = new XYSeries(frame, false);
		final double[] x = g.x(), y = g.y();
		final int links = Math.min(MOST_POINTS, x.length - 1);
		for (int k = 0; k <= links; k++) {
			final int i = (int) Math.rint((double) k * (x.length - 1) / links);
			series.add(x[i], y[i]);
		}
		return series;
	}

	/** Draws each link in the colour of its place. */
	private static final class AlongLength extends XYLineAndShapeRenderer {

		private static final long serialVersionUID = 1L;
		private final transient XYSeriesCollection contours;
		private final transient ColourMap colours;

		AlongLength(final XYSeriesCollection contours, final ColourMap colours) {
			super(true, false);
			this.contours = contours;
			this.colours = colours;
			setDefaultStroke(new BasicStroke(LINE, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
			setAutoPopulateSeriesStroke(false);
		}

		@Override
		public Paint getItemPaint(final int row, final int column) {
			final double part = column / (double) (contours.getItemCount(row) - 1);
			final Color c = colours.colour(part * colours.getUpperBound());
			return new Color(c.getRed(), c.getGreen(), c.getBlue(), 200);
		}
	}
}
