package io.github.knotresolver.imagej.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.Locale;
import java.util.Optional;

import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.IntervalMarker;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

import io.github.knotresolver.measure.DominantFrequency;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.measure.Spectrum;

/**
 * The spectrum of a quantity, with its dominant frequency and whether noise
 * alone could have made it.
 */
final class SpectrumChart {

	private SpectrumChart() {
	}

	/** @return the chart; empty if there are too few frames for a spectrum */
	static Optional<JFreeChart> of(final MovieMeasurements m, final Quantity quantity) {
		final Spectrum spectrum = m.spectrum(quantity);
		if (spectrum.size() == 0)
			return Optional.empty();
		final XYSeries series = new XYSeries("spectrum");
		for (int k = 0; k < spectrum.size(); k++)
			series.add(spectrum.frequency()[k], spectrum.amplitude()[k]);
		final NumberAxis x = ChartStyle.axis("Frequency", m.calibration().frequencyUnit());
		final NumberAxis y = ChartStyle.axis(quantity.label() + ", amplitude", m.unit(quantity));
		x.setRange(0, spectrum.frequency()[spectrum.size() - 1]);
		y.setAutoRangeIncludesZero(true);
		y.setUpperMargin(0.15);
		final XYLineAndShapeRenderer line = new XYLineAndShapeRenderer(true, false);
		line.setSeriesPaint(0, ChartStyle.LINE);
		line.setSeriesStroke(0, new BasicStroke(2));
		final XYPlot plot = new XYPlot(new XYSeriesCollection(series), x, y, line);
		final JFreeChart chart = ChartStyle.chart(plot);
		m.dominantFrequency(quantity).ifPresent(d -> mark(plot, d, m, x.getUpperBound()));
		return Optional.of(chart);
	}

	private static void mark(final XYPlot plot, final DominantFrequency d,
		final MovieMeasurements m, final double highest) {
		final double f = d.frequency();
		plot.addDomainMarker(
			new IntervalMarker(f - d.standardError(), f + d.standardError(), ColourMap.MISSING),
			Layer.BACKGROUND);
		final ValueMarker marker = new ValueMarker(f, ChartStyle.ACCENT, new BasicStroke(1.5f));
		marker.setLabel(text(d, m));
		marker.setLabelFont(ChartStyle.font());
		marker.setLabelBackgroundColor(Color.WHITE);
		final boolean left = f < highest / 2;
		marker.setLabelAnchor(left ? RectangleAnchor.TOP_RIGHT : RectangleAnchor.TOP_LEFT);
		marker.setLabelTextAnchor(left ? TextAnchor.TOP_LEFT : TextAnchor.TOP_RIGHT);
		plot.addDomainMarker(marker);
	}

	private static String text(final DominantFrequency d, final MovieMeasurements m) {
		return String.format(Locale.ROOT, " %.3g \u00b1 %.1g %s, p = %.2g ", d.frequency(),
			d.standardError(), m.calibration().frequencyUnit(), d.falseAlarmProbability());
	}
}
