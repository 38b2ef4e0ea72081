package io.github.knotresolver.reproduction;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

import org.jfree.chart.ChartUtils;
import org.jfree.chart.JFreeChart;

import io.github.knotresolver.imagej.plot.ReproductionCharts;

/**
 * Runs the published evaluation again and writes its tables and figures; called by
 * {@code scripts/reproduce-paper}.
 */
public final class ReproduceMain {

	private static final int WIDTH = 900, SCALE = 2;

	private ReproduceMain() {
	}

	/**
	 * @param args full or quick; the document whose tables are written anew; where
	 *          the new one goes; existing folders of the figures and of the rows
	 * @throws IOException if a file cannot be written
	 */
	public static void main(final String[] args) throws IOException {
		final boolean quick = args[0].equals("quick");
		final Path figures = Path.of(args[3]), rows = Path.of(args[4]);
		final Reproduction reproduction = Reproduction
			.run(quick ? Series.quick() : Series.published());
		writeFrames(rows.resolve("frames.csv"), reproduction.results());
		writeFigures(figures, new ReproductionCharts(reproduction));
		final ReproductionTables tables = new ReproductionTables(reproduction);
		String text = Files.readString(Path.of(args[1]));
		text = replaced(text, "errors", tables.errors());
		text = replaced(text, "conditions", tables.conditions());
		text = replaced(text, "series", tables.series());
		if (quick)
			text = replaced(text, "words", "A quick run: fewer filaments than published.\n");
		Files.writeString(Path.of(args[2]), text);
	}

	private static void writeFigures(final Path folder, final ReproductionCharts charts)
		throws IOException {
		write(folder, "errors", charts.errors(), 900);
		write(folder, "dice-by-snr", charts.diceBySnr(), 520);
		write(folder, "dice-by-interval", charts.diceByInterval(), 520);
		write(folder, "dice-matrix", charts.diceMatrix(), 700);
		write(folder, "frechet-matrix", charts.frechetMatrix(), 700);
	}

	/** Replaces what stands between {@code <!-- name -->} and {@code <!-- end -->}. */
	private static String replaced(final String text, final String name, final String content) {
		final String mark = "<!-- " + name + " -->\n";
		final int from = text.indexOf(mark) + mark.length();
		final int to = text.indexOf("<!-- end -->", from);
		if (from < mark.length() || to < 0)
			throw new IllegalArgumentException(
				"The document has no place for " + name + ": " + mark + "... <!-- end -->");
		return text.substring(0, from) + content + text.substring(to);
	}

	private static void write(final Path folder, final String name, final JFreeChart chart,
		final int height) throws IOException {
		try (OutputStream file = Files.newOutputStream(folder.resolve(name + ".png"))) {
			ChartUtils.writeScaledChartAsPNG(file, chart, WIDTH, height, SCALE, SCALE);
		}
	}

	private static void writeFrames(final Path file, final List<FrameResult> results)
		throws IOException {
		try (PrintStream csv = new PrintStream(Files.newOutputStream(file), false,
			StandardCharsets.UTF_8)) {
			csv.println(
				"length,density,snr,step,method,frame,crossings,dice,frechet_px,mean_error_px");
			for (final FrameResult r : results)
				csv.printf(Locale.ROOT, "%d,%d,%.0f,%d,%s,%d,%d,%.4f,%.3f,%.4f%n",
					r.series().length(), r.series().density(), r.condition().snr(),
					r.condition().step(), r.method().label(), r.frame(), r.crossings(), r.dice(),
					r.frechet(), Arrays.stream(r.errors()).average().orElse(Double.NaN));
		}
	}
}
