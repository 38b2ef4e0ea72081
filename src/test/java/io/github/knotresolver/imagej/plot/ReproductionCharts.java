package io.github.knotresolver.imagej.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.image.BufferedImage;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;

import org.apache.commons.math3.stat.descriptive.DescriptiveStatistics;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.annotations.XYDataImageAnnotation;
import org.jfree.chart.annotations.XYTitleAnnotation;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.SymbolAxis;
import org.jfree.chart.block.BlockBorder;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.CombinedRangeXYPlot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.chart.renderer.xy.XYItemRenderer;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

import io.github.knotresolver.evaluate.ErrorHistogram;
import io.github.knotresolver.reproduction.Condition;
import io.github.knotresolver.reproduction.FrameResult;
import io.github.knotresolver.reproduction.Method;
import io.github.knotresolver.reproduction.Reproduction;
import io.github.knotresolver.reproduction.Series;

/** The figures of {@code docs/reproduction.md}. */
public final class ReproductionCharts {

	/** Width of a histogram's bin and the last error shown, in pixels. */
	private static final double BIN = 0.1, LAST_ERROR = 5;
	private static final double LEAST_DENSITY = 1e-4, MOST_DENSITY = 20;
	private static final int FRAMES = 120;
	/** From this Frechet distance on, colours no longer change, in pixels. */
	private static final double FAR = 20;
	private static final Color[] COLOURS = {Color.BLACK, ChartStyle.LINE, ChartStyle.ACCENT,
		new Color(0x00, 0x9e, 0x73)};

	private final Reproduction reproduction;

	/**
	 * @param reproduction what is shown
	 */
	public ReproductionCharts(final Reproduction reproduction) {
		this.reproduction = reproduction;
	}

	/** @return position errors of the four methods, a panel for each noise level */
	public JFreeChart errors() {
		final CombinedDomainXYPlot panels = new CombinedDomainXYPlot(
			ChartStyle.axis("Position error", "px"));
		panels.setGap(8);
		for (final double snr : Condition.NOISE)
			panels.add(histogram(new Condition(snr, 1)));
		panels.getDomainAxis().setRange(0, LAST_ERROR);
		// A legend of the first panel: the combined plot would say everything four times.
		return withLegend(panels, (XYPlot) panels.getSubplots().get(0));
	}

	private XYPlot histogram(final Condition condition) {
		final XYSeriesCollection lines = new XYSeriesCollection();
		for (final Method method : Method.values())
			lines.addSeries(outline(method, condition));
		final LogAxis density = new LogAxis("Density [1/px]");
		density.setRange(LEAST_DENSITY, MOST_DENSITY);
		density.setTickUnit(new NumberTickUnit(1));
		density.setNumberFormatOverride(
			new DecimalFormat("0.####", DecimalFormatSymbols.getInstance(Locale.ROOT)));
		density.setLabelFont(ChartStyle.font());
		density.setTickLabelFont(ChartStyle.font().deriveFont(12f));
		final XYPlot plot = new XYPlot(lines, null, density,
			coloured(new XYLineAndShapeRenderer(true, false)));
		plot.setBackgroundPaint(Color.WHITE);
		final TextTitle title = new TextTitle(
			String.format(Locale.ROOT, "SNR %.0f dB", condition.snr()),
			ChartStyle.font().deriveFont(Font.BOLD));
		plot.addAnnotation(new XYTitleAnnotation(0.99, 0.96, title, RectangleAnchor.TOP_RIGHT));
		return plot;
	}

	/** The histogram's outline: steps at the bins' edges. */
	private XYSeries outline(final Method method, final Condition condition) {
		final double[] density = ErrorHistogram.of(reproduction.errors(method, condition), BIN)
			.density();
		final XYSeries line = new XYSeries(method.label(), false);
		for (int i = 0; i < Math.min(density.length, LAST_ERROR / BIN); i++) {
			final double d = Math.max(LEAST_DENSITY / 10, density[i]);
			line.add(i * BIN, d);
			line.add((i + 1) * BIN, d);
		}
		return line;
	}

	/** @return Dice index, mean and standard deviation of frames, for each noise level */
	public JFreeChart diceBySnr() {
		final NumberAxis x = ChartStyle.axis("Signal-to-noise ratio", "dB");
		x.setRange(2, 33);
		return dice(x, Condition.NOISE.stream().map(snr -> new Condition(snr, 1)).toList(),
			Condition::snr, 0.4, List.of(Method.values()));
	}

	/** @return Dice index, likewise, for each frame interval */
	public JFreeChart diceByInterval() {
		final String[] names = Condition.STEPS.stream().map(s -> s == 1 ? "1 (all)" : "" + s)
			.toArray(String[]::new);
		final SymbolAxis x = new SymbolAxis("Every how manyth frame is seen", names);
		x.setLabelFont(ChartStyle.font());
		x.setTickLabelFont(ChartStyle.font());
		x.setGridBandsVisible(false);
		return dice(x,
			Condition.STEPS.stream().map(s -> new Condition(Condition.THINNED_NOISE, s)).toList(),
			c -> Condition.STEPS.indexOf(c.step()), 0.06,
			List.of(Method.ACTIVE_CONTOUR, Method.PUBLISHED, Method.OURS));
	}

	/** Methods stand side by side, {@code apart} on the x axis. */
	private JFreeChart dice(final NumberAxis x, final List<Condition> conditions,
		final ToDoubleFunction<Condition> place, final double apart, final List<Method> methods) {
		final XYIntervalSeriesCollection points = new XYIntervalSeriesCollection();
		for (final Method method : Method.values()) {
			final XYIntervalSeries series = new XYIntervalSeries(method.label());
			for (final Condition c : methods.contains(method) ? conditions : List.<Condition>of()) {
				final DescriptiveStatistics dice = new DescriptiveStatistics(
					reproduction.of(method, c).stream().mapToDouble(FrameResult::dice).toArray());
				final double at = place.applyAsDouble(c) + apart * (method.ordinal() - 1.5);
				final double mean = dice.getMean(), sd = dice.getStandardDeviation();
				series.add(at, at, at, mean, mean - sd, mean + sd);
			}
			points.addSeries(series);
		}
		final XYErrorRenderer renderer = new XYErrorRenderer();
		renderer.setDrawXError(false);
		renderer.setDefaultLinesVisible(true);
		renderer.setCapLength(6);
		for (int i = 0; i < Method.values().length; i++)
			renderer.setSeriesVisibleInLegend(i, methods.contains(Method.values()[i]));
		final NumberAxis y = ChartStyle.axis("Dice index, mean and s.d. of frames", "");
		y.setRange(0, 1.1);
		final XYPlot plot = new XYPlot(points, x, y, coloured(renderer));
		return withLegend(plot, plot);
	}

	/** @return Dice index of every frame of every series, published left, ours right */
	public JFreeChart diceMatrix() {
		return matrix(FrameResult::dice, ColourMap.rising(0, 1), "Dice index", "");
	}

	/** @return Frechet distance of every frame of every series, likewise */
	public JFreeChart frechetMatrix() {
		return matrix(r -> Math.min(r.frechet(), FAR), ColourMap.rising(0, FAR),
			"Fr\u00e9chet distance (" + Math.round(FAR) + ": or more)", "px");
	}

	private JFreeChart matrix(final ToDoubleFunction<FrameResult> figure, final ColourMap colours,
		final String label, final String unit) {
		final int rows = reproduction.series().size();
		final SymbolAxis y = new SymbolAxis("Length, motor density",
			reproduction.series().stream().map(Series::toString).toArray(String[]::new));
		y.setLabelFont(ChartStyle.font());
		y.setTickLabelFont(ChartStyle.font().deriveFont(12f));
		y.setGridBandsVisible(false);
		final CombinedRangeXYPlot panels = new CombinedRangeXYPlot(y);
		panels.setGap(14);
		for (final Method method : Method.RESOLVING)
			panels.add(panel(method, image(method, figure, colours), rows));
		y.setRange(-0.5, rows - 0.5);
		final JFreeChart chart = ChartStyle.chart(panels);
		ChartStyle.addColourBar(chart, colours, ChartStyle.axis(label, unit));
		return chart;
	}

	private static XYPlot panel(final Method method, final BufferedImage image, final int rows) {
		final NumberAxis x = ChartStyle.axis("Frame, " + method.label(), "");
		x.setRange(0.5, FRAMES + 0.5);
		final XYPlot plot = new XYPlot(new XYSeriesCollection(), x, null,
			new XYLineAndShapeRenderer());
		plot.setBackgroundPaint(Color.WHITE);
		plot.getRenderer().addAnnotation(new XYDataImageAnnotation(image, 0.5, -0.5, FRAMES, rows),
			Layer.BACKGROUND);
		return plot;
	}

	/** A pixel a frame and series, the first series at the bottom. */
	private BufferedImage image(final Method method, final ToDoubleFunction<FrameResult> figure,
		final ColourMap colours) {
		final List<Series> series = reproduction.series();
		final BufferedImage image = new BufferedImage(FRAMES, series.size(),
			BufferedImage.TYPE_INT_RGB);
		for (final FrameResult r : reproduction.of(method,
			new Condition(Condition.THINNED_NOISE, 1)))
			image.setRGB(r.frame() - 1, series.size() - 1 - series.indexOf(r.series()),
				colours.colour(figure.applyAsDouble(r)).getRGB());
		return image;
	}

	private static XYItemRenderer coloured(final XYItemRenderer renderer) {
		for (int i = 0; i < COLOURS.length; i++) {
			renderer.setSeriesPaint(i, COLOURS[i]);
			renderer.setSeriesStroke(i, new BasicStroke(1.8f));
		}
		return renderer;
	}

	private static JFreeChart withLegend(final XYPlot plot, final XYPlot explained) {
		final JFreeChart chart = ChartStyle.chart(plot);
		final LegendTitle legend = new LegendTitle(explained);
		legend.setPosition(RectangleEdge.TOP);
		legend.setItemFont(ChartStyle.font());
		legend.setFrame(BlockBorder.NONE);
		chart.addSubtitle(legend);
		return chart;
	}
}
