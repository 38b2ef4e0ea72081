package io.github.knotresolver.fit;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.BrightnessProfile.Lengthened;
import io.github.knotresolver.fit.LineEstimator.Example;
import io.github.knotresolver.fit.LineEstimator.LineEstimate;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * How long a filament with a dim end is. Fitted in one frame, such an end is where noise has it, and
 * how bright it is follows from where it is; so it is looked for in all frames together, as bright
 * as it then is.
 *
 * @param length of the filament in pixels
 * @param line the line, and its brightness along the filament
 */
record OneLength(double length, LineEstimate line) {

	/**
	 * A line with its brightness along the filament, as wide as it then is.
	 *
	 * @param line the line as if it were even
	 * @param brightness relative brightness at equal spacing from the fixed end to the tip
	 * @param examples frames and curves
	 * @param progress may cancel
	 * @return the line; as wide as before if an even one does not look narrower than it is
	 */
	static LineEstimate fading(final LineEstimate line, final double[] brightness,
		final List<Example> examples, final Progress progress) {
		final LineEstimate fading = line.withModel(line.model().withBrightness(brightness));
		return isKnownBetter(fading, examples)
			? LineEstimator.withWidth(examples, fading, progress)
			: fading;
	}

	/**
	 * What is known of a filament; if an end is dim, with the length that all frames have together.
	 *
	 * @param free what follows from curves of any length
	 * @param line the line, and its brightness along the filament
	 * @param examples frames and those curves
	 * @param endsFree weights of a fit with both ends and the length free
	 * @param workers threads
	 * @param progress asked whether to stop
	 * @return the same if all ends are bright, or something else shines
	 */
	static FilamentEstimate of(final FilamentEstimate free, final LineEstimate line,
		final List<Example> examples, final FitSettings endsFree, final Workers workers,
		final Progress progress) {
		return isKnownBetter(line, examples)
			? new OneLength(free.length(), line).settled(examples, endsFree, workers, progress)
				.of(free)
			: free;
	}

	/**
	 * @param line the line, and its brightness along the filament
	 * @param examples frames and curves
	 * @return whether an end is dim, the line's light adds up and is all there is beside noise, and
	 *         there are enough curves that are equally long
	 */
	private static boolean isKnownBetter(final LineEstimate line, final List<Example> examples) {
		if (line.model().kind() != LineModel.Kind.ADDITIVE || !line.model().hasDimEnd()
			|| examples.size() < FitTuning.FEWEST_TAPERS)
			return false;
		final double[] lengths = examples.stream().mapToDouble(e -> e.chain().length()).toArray();
		final double usual = RobustStatistics.median(lengths);
		final boolean equallyLong = RobustStatistics.median(Arrays.stream(lengths)
			.map(l -> Math.abs(l / usual - 1)).toArray()) < FitTuning.ONE_LENGTH;
		if (!equallyLong)
			return false;
		final LineEstimate fading = LineEstimator.fit(examples, line.model());
		return fading.residual() - fading.noise() < FitTuning.FADING_MISFIT;
	}

	/** The length, and the brightness along it, that explain all best. O(rounds) fits of each. */
	private OneLength settled(final List<Example> examples, final FitSettings endsFree,
		final Workers workers, final Progress progress) {
		final double[] bright = line.model().brightness();
		if (bright[0] < line.model().atTip())
			return reversed().settledAtTip(whole(examples).stream()
				.map(e -> new Example(e.frame(), e.chain().reversed())).toList(), endsFree, workers,
				progress).reversed();
		return settledAtTip(whole(examples), endsFree, workers, progress);
	}

	private OneLength settledAtTip(final List<Example> examples, final FitSettings endsFree,
		final Workers workers, final Progress progress) {
		OneLength now = this;
		List<Example> fitted = examples;
		double missing = Double.POSITIVE_INFINITY;
		for (int round = 0; round < FitTuning.MOST_PROFILE_ROUNDS
			&& Math.abs(missing) > FitTuning.PROFILE_SETTLED * length; round++) {
			fitted = now.fitted(fitted, endsFree, workers, progress);
			final Lengthened found = BrightnessProfile.lengthened(fitted, now.line);
			missing = Math.max(-FitTuning.TIP_STEP, Math.min(FitTuning.TIP_STEP, found.missing()));
			now = new OneLength(now.length + missing,
				now.line.withModel(now.line.model().withBrightness(found.brightness())));
		}
		return now;
	}

	private List<Example> fitted(final List<Example> examples, final FitSettings endsFree,
		final Workers workers, final Progress progress) {
		return workers.map(examples.size(), i -> {
			progress.checkCancelled();
			final Example e = examples.get(i);
			final Chain start = e.chain().resized(length);
			return new Example(e.frame(),
				new FilamentFitter(line.scaled(e), line.model(), start.links(), Optional.empty(),
					endsFree.withFreeLength(false)).fit(start, Optional.empty()).chain());
		});
	}

	/** Those that are about as long. */
	private List<Example> whole(final List<Example> examples) {
		return examples.stream()
			.filter(e -> Math.abs(e.chain().length() / length - 1) < FitTuning.LENGTH_OUTLIER)
			.toList();
	}

	private OneLength reversed() {
		return new OneLength(length, line.withModel(line.model().reversed()));
	}

	/** The same filament, so long and so bright. */
	private FilamentEstimate of(final FilamentEstimate filament) {
		return new FilamentEstimate(line.model(), filament.amplitude(), length,
			filament.lengthError(), filament.fixedEnd(), filament.guessed());
	}
}
