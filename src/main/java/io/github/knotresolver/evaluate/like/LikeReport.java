package io.github.knotresolver.evaluate.like;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

import org.apache.commons.math3.stat.StatUtils;

import io.github.knotresolver.evaluate.CurveScore;
import io.github.knotresolver.evaluate.ErrorHistogram;
import io.github.knotresolver.evaluate.like.LikeResult.LikeMovie;

/** A study of movies like a user's in a few lines, for people. */
public final class LikeReport {

	private final LikeResult result;
	private final List<String> lines = new ArrayList<>();

	private LikeReport(final LikeResult result) {
		this.result = result;
	}

	/**
	 * @param result the study
	 * @return how often and how exactly such movies are resolved, and how closely
	 *         they resemble the user's; figures that there are not are left out
	 */
	public static List<String> lines(final LikeResult result) {
		final LikeReport report = new LikeReport(result);
		report.addHeader();
		report.addRefusals();
		report.addScores();
		report.addConfidence();
		report.addResemblance();
		return List.copyOf(report.lines);
	}

	private void addHeader() {
		add("%d simulated movies like '%s', %d frames each, resolved as yours was:",
			result.movies().size(), result.source().movie().name(), result.source().movie().size());
	}

	private void addRefusals() {
		final List<String> refusals = result.movies().stream().map(LikeMovie::refusal)
			.flatMap(Optional::stream).toList();
		if (!refusals.isEmpty())
			add("%d of them were refused, the first with: %s", refusals.size(), refusals.get(0));
	}

	private void addScores() {
		addShare("resolved (Frechet < 5 px)", result.resolved());
		addShare("  where it meets itself", result.knottedResolved());
		addShare("  where it crosses itself", result.crossingResolved());
		final double[] errors = result.positionErrors();
		if (errors.length == 0)
			return;
		add("%-28s mean %.3f px, median %.3f px", "position error", StatUtils.mean(errors),
			StatUtils.percentile(errors, 50));
		ErrorHistogram.of(errors, ErrorHistogram.FINE_BIN).gaussian().ifPresent(
			g -> add("%-28s mean %.3f px, sigma %.3f px", "  Gaussian fit", g.mean(), g.sigma()));
		final double[] length = result.scores(CurveScore::lengthError);
		add("%-28s mean %+.2f %%, median magnitude %.2f %%", "length error", StatUtils.mean(length),
			StatUtils.percentile(Arrays.stream(length).map(Math::abs).toArray(), 50));
		add("%-28s mean %.4f", "Dice index", StatUtils.mean(result.scores(CurveScore::dice)));
		add("%-28s median %.3f px", "Frechet distance",
			StatUtils.percentile(result.scores(CurveScore::frechet), 50));
	}

	private void addShare(final String what, final ClusteredProportion share) {
		if (!Double.isNaN(share.percent()))
			add("%-28s %.1f %% (95 %% interval %.1f to %.1f %%)", what, share.percent(),
				share.low(), share.high());
	}

	private void addConfidence() {
		final double[] right = result.confidence(true), wrong = result.confidence(false);
		if (wrong.length == 0) {
			add("%-28s no frame has a wrong contour, so it had nothing to tell", "confidence");
			return;
		}
		add("%-28s median %s where right, %s where wrong (%d frames)", "confidence", median(right),
			median(wrong), wrong.length);
		if (right.length > 0)
			add("%-28s %.3f (area under the ROC curve; 0.5 is chance)", "  tells right from wrong",
				result.discrimination());
	}

	private static String median(final double[] values) {
		return values.length == 0
			? "-"
			: String.format(Locale.ROOT, "%.3f", StatUtils.percentile(values, 50));
	}

	private void addResemblance() {
		add("%-34s %10s %10s", "Resemblance", "yours", "simulated");
		for (final Map.Entry<String, Double> trait : result.traits().values().entrySet())
			add("%-34s %10s %10s", trait.getKey(), text(trait.getValue()),
				text(result.simulated(trait.getKey())));
		addMotion();
	}

	private void addMotion() {
		final double density = result.motion().density();
		result.speed().ifPresentOrElse(speed -> add(
			"Simulated with %.0f motors/µm² and time running %.2f times as fast as in the model's default.",
			density, speed),
			() -> add(
				"Simulated with %.0f motors/µm² and %.3g s from frame to frame; the movie does not tell its own frame interval.",
				density, result.motion().interval()));
	}

	private static String text(final double value) {
		return Double.isNaN(value) ? "-" : String.format(Locale.ROOT, "%.4g", value);
	}

	private void add(final String format, final Object... values) {
		lines.add(String.format(Locale.ROOT, format, values));
	}
}
