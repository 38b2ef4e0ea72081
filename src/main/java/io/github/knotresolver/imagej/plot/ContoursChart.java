package io.github.knotresolver.imagej.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Paint;
import java.util.List;

import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.data.Range;
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
		final List<FrameMeasurement> measured = m.measured();
		final XYSeriesCollection contours = new XYSeriesCollection();
		final int stride = 1 + (measured.size() - 1) / MOST_FRAMES;
		double longest = 0;
		for (int i = 0; i < measured.size(); i += stride) {
			final ContourGeometry g = measured.get(i).geometry().orElseThrow();
			longest = Math.max(longest, g.length());
			contours.addSeries(series(measured.get(i).frame(), g));
		}
		final ColourMap colours = ColourMap.rising(0, longest);
		final NumberAxis x = ChartStyle.axis("x", m.calibration().unit());
		final NumberAxis y = ChartStyle.axis("y", m.calibration().unit());
		y.setInverted(true);
		final XYPlot plot = new XYPlot(contours, x, y, new AlongLength(contours, colours));
		final JFreeChart chart = ChartStyle.chart(plot);
		fit(x, contours.getDomainBounds(false), y, contours.getRangeBounds(false));
		ChartStyle.addColourBar(chart, colours,
			ChartStyle.axis("Arc length from the fixed end", m.calibration().unit()));
		return chart;
	}

	/** Both axes get the same extent, so that a square chart shows true shapes. */
	private static void fit(final NumberAxis x, final Range xs, final NumberAxis y,
		final Range ys) {
		final double half = Math.max(xs.getLength(), ys.getLength()) * (0.5 + MARGIN);
		x.setRange(xs.getCentralValue() - half, xs.getCentralValue() + half);
		y.setRange(ys.getCentralValue() - half, ys.getCentralValue() + half);
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
