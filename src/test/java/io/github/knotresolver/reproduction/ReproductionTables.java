package io.github.knotresolver.reproduction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

import org.apache.commons.math3.stat.descriptive.DescriptiveStatistics;

import io.github.knotresolver.evaluate.ErrorHistogram;

/** The tables of {@code docs/reproduction.md}, as Markdown. */
final class ReproductionTables {

	private static final double BIN = 0.1;

	private final Reproduction reproduction;

	ReproductionTables(final Reproduction reproduction) {
		this.reproduction = reproduction;
	}

	/** @return position errors by noise and method */
	String errors() {
		final List<List<String>> rows = new ArrayList<>();
		for (final double snr : Condition.NOISE)
			for (final Method method : Method.values()) {
				final double[] errors = reproduction.errors(method, new Condition(snr, 1));
				final DescriptiveStatistics all = new DescriptiveStatistics(errors);
				final Optional<ErrorHistogram.Gaussian> fit = ErrorHistogram.of(errors, BIN)
					.gaussian();
				rows.add(List.of(text("%.0f", snr), method.label(), "" + errors.length,
					text("%.2f", all.getMean()), text("%.2f", all.getPercentile(95)),
					fit.map(g -> text("%.2f", g.mean())).orElse("-"),
					fit.map(g -> text("%.2f", g.sigma())).orElse("-")));
			}
		return table(2, rows, "SNR [dB]", "method", "points", "mean error [px]",
			"95th percentile [px]", "Gaussian fit: mean [px]", "sigma [px]");
	}

	/** @return Dice index and resolved frames by condition and method */
	String conditions() {
		final List<List<String>> rows = new ArrayList<>();
		for (final Condition condition : Condition.all())
			for (final Method method : Method.values())
				rows.add(row(condition, method));
		return table(3, rows, "SNR [dB]", "frames seen", "method", "frames", "Dice, mean",
			"Dice, s.d.", "resolved [%]", "resolved crossing frames [%]", "Fréchet, median [px]");
	}

	private List<String> row(final Condition condition, final Method method) {
		final List<FrameResult> frames = reproduction.of(method, condition);
		final DescriptiveStatistics dice = new DescriptiveStatistics(
			frames.stream().mapToDouble(FrameResult::dice).toArray());
		return List.of(text("%.0f", condition.snr()),
			condition.step() == 1 ? "all" : "every " + condition.step() + "th", method.label(),
			"" + frames.size(), text("%.3f", dice.getMean()),
			text("%.3f", dice.getStandardDeviation()),
			resolving(method, Reproduction.percentResolved(frames, f -> true), "%.1f"),
			resolving(method, Reproduction.percentResolved(frames, f -> f.crossings() > 0), "%.1f"),
			resolving(method, median(frames), "%.2f"));
	}

	/** @return each series at the noise of the matrix, published and ours */
	String series() {
		final List<List<String>> rows = new ArrayList<>();
		for (final Series series : reproduction.series()) {
			final List<String> row = new ArrayList<>(
				List.of("" + series.length(), "" + series.density()));
			for (final Method method : Method.RESOLVING) {
				final List<FrameResult> frames = reproduction
					.of(method, new Condition(Condition.THINNED_NOISE, 1)).stream()
					.filter(f -> f.series().equals(series)).toList();
				if (method == Method.RESOLVING.get(0))
					row.add("" + frames.stream().filter(f -> f.crossings() > 0).count());
				row.add(text("%.3f",
					frames.stream().mapToDouble(FrameResult::dice).average().orElse(Double.NaN)));
				row.add(text("%.2f", median(frames)));
				row.add(text("%.1f", Reproduction.percentResolved(frames, f -> true)));
			}
			rows.add(row);
		}
		return table(0, rows, "length [µm]", "motors/µm²", "frames with crossings",
			"published: Dice", "Fréchet, median [px]", "resolved [%]", "ours: Dice",
			"Fréchet, median [px]", "resolved [%]");
	}

	private static double median(final List<FrameResult> frames) {
		final double[] sorted = frames.stream().mapToDouble(FrameResult::frechet).sorted()
			.toArray();
		return sorted[sorted.length / 2];
	}

	private static String resolving(final Method method, final double value, final String format) {
		return method.resolves() ? text(format, value) : "-";
	}

	private static String text(final String format, final double value) {
		return Double.isNaN(value)
			? "-"
			: Double.isInfinite(value) ? "∞" : String.format(Locale.ROOT, format, value);
	}

	/** @param words columns from the left that hold words */
	private static String table(final int words, final List<List<String>> rows,
		final String... header) {
		final StringBuilder table = new StringBuilder(line(Arrays.asList(header)));
		final List<String> rule = new ArrayList<>();
		for (int i = 0; i < header.length; i++)
			rule.add(i < words ? "---" : "---:");
		table.append(line(rule));
		rows.forEach(row -> table.append(line(row)));
		return table.toString();
	}

	private static String line(final List<String> cells) {
		return "| " + String.join(" | ", cells) + " |\n";
	}
}
