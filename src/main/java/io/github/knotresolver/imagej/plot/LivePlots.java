package io.github.knotresolver.imagej.plot;

import ij.gui.Plot;
import ij.measure.ResultsTable;
import io.github.knotresolver.measure.FrameMeasurement;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.measure.Spectrum;

/**
 * Measurements as ImageJ's own plots, which users restyle, zoom and list as
 * tables, and as one table with a row a frame.
 */
public final class LivePlots {

	private LivePlots() {
	}

	/**
	 * @param m the measurements
	 * @param quantity what
	 * @return its plot over time with error bars; frames without a contour are gaps
	 */
	public static Plot series(final MovieMeasurements m, final Quantity quantity) {
		final Plot plot = new Plot(m.name() + "-" + quantity.key(),
			ChartStyle.label("Time", m.calibration().timeUnit()),
			ChartStyle.label(quantity.label(), m.unit(quantity)));
		plot.setColor(ChartStyle.LINE);
		plot.add("connected", m.times(), m.series(quantity));
		if (quantity != Quantity.CROSSINGS)
			plot.addErrorBars(m.errors(quantity));
		return plot;
	}

	/**
	 * @param m the measurements
	 * @param quantity what
	 * @return its spectrum
	 */
	public static Plot spectrum(final MovieMeasurements m, final Quantity quantity) {
		final Spectrum spectrum = m.spectrum(quantity);
		final Plot plot = new Plot(m.name() + "-" + quantity.key() + "-spectrum",
			ChartStyle.label("Frequency", m.frequencyUnit()),
			ChartStyle.label(quantity.label() + ", amplitude", m.unit(quantity)));
		plot.setColor(ChartStyle.LINE);
		plot.add("line", spectrum.frequency(), spectrum.amplitude());
		return plot;
	}

	/**
	 * @param m the measurements
	 * @return one row a frame: frame, time, every quantity and its standard error,
	 *         with units in the headings; empty cells where a frame is missing
	 */
	public static ResultsTable table(final MovieMeasurements m) {
		final ResultsTable table = new ResultsTable();
		table.setNaNEmptyCells(true);
		final double[] time = m.times();
		for (final FrameMeasurement f : m.frames()) {
			table.addRow();
			table.addValue("frame", f.frame());
			table.addValue(ChartStyle.label("time", m.calibration().timeUnit()),
				time[f.frame() - 1]);
			for (final Quantity q : Quantity.values()) {
				table.addValue(ChartStyle.label(q.key(), m.unit(q)), f.get(q).value());
				if (q != Quantity.CROSSINGS)
					table.addValue(ChartStyle.label(q.key() + "_se", m.unit(q)),
						f.get(q).standardError());
			}
		}
		return table;
	}

	/**
	 * Shows the kymographs of tangent angle and curvature, zoomed to a useful size.
	 *
	 * @param m the measurements
	 */
	public static void showKymographs(final MovieMeasurements m) {
		KymographImage.show(Figures.tangentAngleImage(m));
		KymographImage.show(Figures.curvatureImage(m));
	}
}
