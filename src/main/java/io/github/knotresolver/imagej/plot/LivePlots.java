package io.github.knotresolver.imagej.plot;

import java.util.List;
import java.util.function.Function;
import java.util.stream.DoubleStream;

import ij.gui.Plot;
import ij.measure.ResultsTable;
import io.github.knotresolver.measure.ContourGeometry;
import io.github.knotresolver.measure.FrameMeasurement;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.measure.Spectrum;

/**
 * Measurements as ImageJ's own plots, which users restyle, zoom and list as
 * tables, and as one table with a row a frame.
 */
public final class LivePlots {

	/** Edge of the contours' plot in pixels, and parts of a contour with a colour each. */
	private static final int SQUARE = 400, COLOURS = 16;

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
			ChartStyle.label("Frequency", m.calibration().frequencyUnit()),
			ChartStyle.label(quantity.label() + ", amplitude", m.unit(quantity)));
		plot.setColor(ChartStyle.LINE);
		plot.add("line", spectrum.frequency(), spectrum.amplitude());
		return plot;
	}

	/**
	 * All contours in one plot, in the image's own axes, with colour along the
	 * length; of a long movie, evenly chosen frames.
	 *
	 * @param m the measurements
	 * @return the plot; a series for each colour
	 */
	public static Plot contours(final MovieMeasurements m) {
		final List<ContourGeometry> shown = ContoursChart.shown(m).stream()
			.map(f -> f.geometry().orElseThrow()).toList();
		final String unit = m.calibration().unit();
		final Plot plot = new Plot(m.name() + "-projection", ChartStyle.label("x", unit),
			ChartStyle.label("y", unit));
		plot.setFrameSize(SQUARE, SQUARE);
		final double longest = shown.stream().mapToDouble(ContourGeometry::length).max()
			.orElseThrow();
		final ColourMap colours = ColourMap.rising(0, longest);
		final double[] view = ContoursChart.view(shown);
		plot.setLimits(view[0], view[1], view[3], view[2]);
		for (int k = 0; k < COLOURS; k++) {
			plot.setColor(colours.colour((k + 0.5) / COLOURS * longest));
			plot.add("line", part(shown, k, ContourGeometry::x),
				part(shown, k, ContourGeometry::y));
		}
		return plot;
	}

	/** One coordinate of a part of all contours, with gaps between them. */
	private static double[] part(final List<ContourGeometry> contours, final int part,
		final Function<ContourGeometry, double[]> coordinate) {
		final DoubleStream.Builder values = DoubleStream.builder();
		for (final ContourGeometry g : contours) {
			final double[] all = coordinate.apply(g);
			final int from = part * (all.length - 1) / COLOURS,
				to = (part + 1) * (all.length - 1) / COLOURS;
			for (int i = from; i <= to; i++)
				values.add(all[i]);
			values.add(Double.NaN);
		}
		return values.build().toArray();
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
}
