package io.github.knotresolver.imagej.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.math.BigDecimal;
import java.math.MathContext;
import java.text.FieldPosition;
import java.text.NumberFormat;
import java.text.ParsePosition;

import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.PaintScale;
import org.jfree.chart.title.PaintScaleLegend;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;

/** One look for all charts: white, thin grey grid, print-sized letters. */
final class ChartStyle {

	/** The line of a single series. */
	static final Color LINE = new Color(0x00, 0x72, 0xb2);
	/** What stands out against {@link #LINE}. */
	static final Color ACCENT = new Color(0xd5, 0x5e, 0x00);

	private static final Font LABEL = new Font(Font.SANS_SERIF, Font.PLAIN, 15);
	private static final Font TICK = new Font(Font.SANS_SERIF, Font.PLAIN, 14);
	private static final Color GRID = new Color(0xe0, 0xe0, 0xe0);
	private static final double BAR = 12;

	private ChartStyle() {
	}

	/** @return an axis with a label; a unit is put in brackets */
	static NumberAxis axis(final String label, final String unit) {
		final NumberAxis axis = new NumberAxis(label(label, unit));
		axis.setAutoRangeIncludesZero(false);
		axis.setNumberFormatOverride(new TickFormat());
		dress(axis);
		return axis;
	}

	/** @return {@code label [unit]}, or the label alone */
	static String label(final String label, final String unit) {
		return unit.isEmpty() ? label : label + " [" + unit + "]";
	}

	private static void dress(final ValueAxis axis) {
		axis.setLabelFont(LABEL);
		axis.setTickLabelFont(TICK);
		axis.setLabelPaint(Color.BLACK);
		axis.setTickLabelPaint(Color.BLACK);
		axis.setAxisLinePaint(Color.BLACK);
		axis.setTickMarkPaint(Color.BLACK);
	}

	/** @return a chart of the plot, without title or legend */
	static JFreeChart chart(final XYPlot plot) {
		plot.setBackgroundPaint(Color.WHITE);
		plot.setDomainGridlinePaint(GRID);
		plot.setRangeGridlinePaint(GRID);
		plot.setDomainGridlineStroke(new BasicStroke(1));
		plot.setRangeGridlineStroke(new BasicStroke(1));
		plot.setOutlinePaint(Color.BLACK);
		plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
		final JFreeChart chart = new JFreeChart(null, LABEL, plot, false);
		chart.setBackgroundPaint(Color.WHITE);
		chart.setPadding(new RectangleInsets(6, 6, 6, 14));
		return chart;
	}

	/** Puts a colour bar to the right. */
	static void addColourBar(final JFreeChart chart, final PaintScale colours,
		final NumberAxis axis) {
		final PaintScaleLegend bar = new PaintScaleLegend(colours, axis);
		bar.setPosition(RectangleEdge.RIGHT);
		bar.setStripWidth(BAR);
		bar.setSubdivisionCount(200);
		bar.setStripOutlineVisible(false);
		bar.setBackgroundPaint(Color.WHITE);
		bar.setMargin(6, 10, 42, 0);
		chart.addSubtitle(bar);
	}

	static Font font() {
		return TICK;
	}

	/** Numbers on axes: a dot in any locale, no needless zeros. */
	private static final class TickFormat extends NumberFormat {

		private static final long serialVersionUID = 1L;
		private static final MathContext DIGITS = new MathContext(6);
		/** Rounding errors of an axis's arithmetic: below this a tick is 0. */
		private static final double NOTHING = 1e-12;

		@Override
		public StringBuffer format(final double number, final StringBuffer to,
			final FieldPosition at) {
			if (!Double.isFinite(number) || Math.abs(number) < NOTHING)
				return to.append('0');
			final String plain = new BigDecimal(number).round(DIGITS).stripTrailingZeros()
				.toPlainString();
			return to.append(plain.replace('-', '\u2212'));
		}

		@Override
		public StringBuffer format(final long number, final StringBuffer to,
			final FieldPosition at) {
			return format((double) number, to, at);
		}

		@Override
		public Number parse(final String source, final ParsePosition position) {
			throw new UnsupportedOperationException("Ticks are written, not read.");
		}
	}
}
