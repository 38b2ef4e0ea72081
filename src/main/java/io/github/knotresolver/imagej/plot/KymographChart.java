package io.github.knotresolver.imagej.plot;

import java.awt.image.BufferedImage;
import java.util.Arrays;

import org.jfree.chart.JFreeChart;
import org.jfree.chart.annotations.XYDataImageAnnotation;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.data.xy.XYSeriesCollection;

import io.github.knotresolver.measure.Kymograph;
import io.github.knotresolver.measure.MovieMeasurements;

/**
 * A kymograph as a chart: time to the right, arc length upwards from the fixed
 * end; what is missing is grey.
 */
final class KymographChart {

	/** Part of the values that may lie beyond the ends of the colours. */
	private static final double OUTLIERS = 0.01;

	private KymographChart() {
	}

	/** @return the tangent angle's chart */
	static JFreeChart tangentAngle(final MovieMeasurements m) {
		final Kymograph k = m.tangentAngleKymograph();
		final double[] sorted = sorted(k);
		return chart(m, k,
			ColourMap.rising(quantile(sorted, OUTLIERS), quantile(sorted, 1 - OUTLIERS)),
			"Tangent angle \u03c8", "rad");
	}

	/** @return the curvature's chart, with white for straight */
	static JFreeChart curvature(final MovieMeasurements m) {
		final Kymograph k = m.curvatureKymograph();
		final double[] sorted = Arrays.stream(sorted(k)).map(Math::abs).sorted().toArray();
		return chart(m, k, ColourMap.twoSided(quantile(sorted, 1 - OUTLIERS)), "Curvature \u03ba",
			"1/" + m.calibration().unit());
	}

	private static JFreeChart chart(final MovieMeasurements m, final Kymograph k,
		final ColourMap colours, final String label, final String unit) {
		final double duration = k.frames() * k.interval(), extent = k.columns() * k.step();
		final NumberAxis time = ChartStyle.axis("Time", m.calibration().timeUnit());
		final NumberAxis place = ChartStyle.axis("Arc length", m.calibration().unit());
		// A frame fills the interval around its time, a place the step around it.
		time.setRange(-k.interval() / 2, duration - k.interval() / 2);
		place.setRange(-k.step() / 2, extent - k.step() / 2);
		final XYPlot plot = new XYPlot(new XYSeriesCollection(), time, place,
			new XYLineAndShapeRenderer());
		final JFreeChart chart = ChartStyle.chart(plot);
		plot.setDomainGridlinesVisible(false);
		plot.setRangeGridlinesVisible(false);
		plot.getRenderer().addAnnotation(new XYDataImageAnnotation(image(k, colours),
			-k.interval() / 2, -k.step() / 2, duration, extent), Layer.BACKGROUND);
		ChartStyle.addColourBar(chart, colours, ChartStyle.axis(label, unit));
		return chart;
	}

	/** One pixel a frame and step; charts scale it without blurring. */
	private static BufferedImage image(final Kymograph k, final ColourMap colours) {
		final BufferedImage image = new BufferedImage(k.frames(), k.columns(),
			BufferedImage.TYPE_INT_RGB);
		for (int t = 0; t < k.frames(); t++)
			for (int j = 0; j < k.columns(); j++)
				image.setRGB(t, k.columns() - 1 - j, colours.colour(k.values()[t][j]).getRGB());
		return image;
	}

	private static double[] sorted(final Kymograph k) {
		return Arrays.stream(k.values()).flatMapToDouble(Arrays::stream).filter(Double::isFinite)
			.sorted().toArray();
	}

	private static double quantile(final double[] sorted, final double part) {
		return sorted[(int) Math.rint(part * (sorted.length - 1))];
	}
}
