package io.github.knotresolver.imagej.plot;

import java.awt.Graphics2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;

import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.plot.XYPlot;

import ij.ImagePlus;
import ij.gui.Plot;
import io.github.knotresolver.measure.ContourGeometry;
import io.github.knotresolver.measure.FrameMeasurement;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;

/**
 * A figure of measurements that leads back to the frames: it is drawn at any size, and tells which
 * frame is at a place of the drawing.
 */
public final class LiveFigure {

	/** Which frame a place in the units of the axes belongs to. */
	@FunctionalInterface
	private interface Finder {

		OptionalInt frame(double x, double y);
	}

	private final String key;
	private final JFreeChart chart;
	private final Finder finder;
	private final boolean overTime;
	private final MovieMeasurements measurements;
	private final ChartRenderingInfo drawn = new ChartRenderingInfo();

	private LiveFigure(final String key, final JFreeChart chart, final MovieMeasurements m) {
		this.key = key;
		this.chart = chart;
		measurements = m;
		overTime = !key.endsWith("_spectrum") && !key.equals("contours");
		finder = overTime
			? this::atTime
			: key.equals("contours") ? this::nearest : (x, y) -> OptionalInt.empty();
	}

	/**
	 * @param m measurements of a filament
	 * @return all their figures, in a fixed order
	 */
	public static List<LiveFigure> of(final MovieMeasurements m) {
		final List<LiveFigure> all = new ArrayList<>();
		Figures.charts(m).forEach((key, chart) -> all.add(new LiveFigure(key, chart, m)));
		return all;
	}

	/** @return the name of its file, without ending */
	public String key() {
		return key;
	}

	/**
	 * Draws it.
	 *
	 * @param g where
	 * @param width in units of {@code g}
	 * @param height likewise
	 * @param frame this one is marked, if time runs along an axis; 0 for none
	 */
	public void draw(final Graphics2D g, final int width, final int height, final int frame) {
		final Rectangle2D area = new Rectangle2D.Double(0, 0, width, height);
		chart.draw(g, area, drawn);
		if (!overTime || frame < 1 || frame > measurements.frames().size())
			return;
		final Rectangle2D data = drawn.getPlotInfo().getDataArea();
		final XYPlot plot = (XYPlot) chart.getPlot();
		final int x = (int) Math.rint(plot.getDomainAxis()
			.valueToJava2D(measurements.times()[frame - 1], data, plot.getDomainAxisEdge()));
		g.setColor(ChartStyle.ACCENT);
		g.drawLine(x, (int) data.getMinY(), x, (int) data.getMaxY());
	}

	/**
	 * @param place in the last drawing
	 * @return the frame there, from 1; empty if none is, or it was never drawn
	 */
	public OptionalInt frameAt(final Point2D place) {
		final Rectangle2D data = drawn.getPlotInfo().getDataArea();
		if (data == null || !data.contains(place))
			return OptionalInt.empty();
		final XYPlot plot = (XYPlot) chart.getPlot();
		return finder.frame(
			plot.getDomainAxis().java2DToValue(place.getX(), data, plot.getDomainAxisEdge()),
			plot.getRangeAxis().java2DToValue(place.getY(), data, plot.getRangeAxisEdge()));
	}

	private OptionalInt atTime(final double time, final double value) {
		final double[] times = measurements.times();
		int best = 0;
		for (int i = 1; i < times.length; i++)
			if (Math.abs(times[i] - time) < Math.abs(times[best] - time))
				best = i;
		return OptionalInt.of(best + 1);
	}

	/** The frame whose contour is nearest. */
	private OptionalInt nearest(final double x, final double y) {
		double best = Double.POSITIVE_INFINITY;
		int frame = 0;
		for (final FrameMeasurement f : measurements.frames()) {
			final Optional<ContourGeometry> geometry = f.geometry();
			if (geometry.isEmpty())
				continue;
			final double[] xs = geometry.get().x(), ys = geometry.get().y();
			for (int i = 0; i < xs.length; i++)
				if (Math.hypot(xs[i] - x, ys[i] - y) < best) {
					best = Math.hypot(xs[i] - x, ys[i] - y);
					frame = f.frame();
				}
		}
		return frame == 0 ? OptionalInt.empty() : OptionalInt.of(frame);
	}

	/** Shows it as ImageJ's own: a plot to restyle, or a kymograph of 32 bit to measure on. */
	public void showInImageJ() {
		if (key.endsWith("_kymograph"))
			KymographImage.show(kymograph());
		else if (key.equals("contours"))
			LivePlots.contours(measurements).show();
		else
			plot().show();
	}

	/** Shows its values as a table; of a kymograph, the image that holds them. */
	public void showData() {
		if (key.endsWith("_kymograph"))
			KymographImage.show(kymograph());
		else
			(key.equals("contours") ? LivePlots.contours(measurements) : plot()).getResultsTable()
				.show(measurements.name() + "-" + key);
	}

	private ImagePlus kymograph() {
		return key.startsWith("tangent")
			? Figures.tangentAngleImage(measurements)
			: Figures.curvatureImage(measurements);
	}

	private Plot plot() {
		final boolean spectrum = key.endsWith("_spectrum");
		final String name = spectrum ? key.substring(0, key.lastIndexOf('_')) : key;
		for (final Quantity q : Quantity.values())
			if (q.key().equals(name))
				return spectrum
					? LivePlots.spectrum(measurements, q)
					: LivePlots.series(measurements, q);
		throw new IllegalStateException(key);
	}

	/**
	 * @param file a new file: SVG if it ends so, else PNG
	 * @throws IOException if it cannot be written
	 */
	public void save(final Path file) throws IOException {
		if (file.toString().toLowerCase(Locale.ROOT).endsWith(".svg"))
			SvgChart.write(file, chart, Figures.WIDTH, Figures.HEIGHT);
		else
			Files.write(file, Figures.png(chart, Figures.WIDTH, Figures.HEIGHT));
	}
}
