package io.github.knotresolver.fit;

import java.util.List;
import java.util.function.Function;

import io.github.knotresolver.fit.LineEstimator.Example;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.LineAppearance;

/**
 * Ends at which light is no more than what lies beyond them: there the brightness falls, within a
 * few line widths, to a fraction of what it was. Curves were led on into haze. A dim tip is reached
 * slowly, and how blunt the end of a line is belongs to the line.
 *
 * @param start distance from the fixed end in pixels at which the brightness is half of what it is
 *          before it falls; 0 if it does not
 * @param tip the same of the tip
 */
record FadedEnds(double start, double tip) {

	/**
	 * @param line what the filament looks like
	 * @param length of the filament in pixels
	 */
	static FadedEnds of(final LineModel line, final double length) {
		return new FadedEnds(faded(line.reversed().brightness(), length),
			faded(line.brightness(), length));
	}

	private static double faded(final double[] brightness, final double length) {
		final int last = brightness.length - 1;
		final double spacing = length / Math.max(1, last);
		final double before = brightness[Math.max(0,
			last - (int) Math.rint(FitTuning.THIRD_END_KNOT / spacing))];
		if (brightness[last] > FitTuning.FADED_END * before)
			return 0;
		int at = last;
		while (brightness[at] < 0.5 * before)
			at--;
		final double share = (0.5 * before - brightness[at])
			/ (brightness[at + 1] - brightness[at]);
		return (last - at - share) * spacing;
	}

	/** Whether neither end fades. */
	boolean areNone() {
		return Math.max(start, tip) == 0;
	}

	/** Curves without what lies beyond them. */
	List<Example> cutFrom(final List<Example> examples) {
		return examples.stream().map(e -> {
			final Chain back = e.chain().resized(e.chain().length() - tip).reversed();
			return new Example(e.frame(), back.resized(back.length() - start).reversed());
		}).toList();
	}

	/** Whether one of them is within a line's width of the picture's border in most frames. */
	boolean areAtBorder(final List<Example> examples, final double sigma) {
		final double width = LineAppearance.FULL_WIDTH * sigma;
		return start > 0 && isAtBorder(examples, Chain::start, width)
			|| tip > 0 && isAtBorder(examples, Chain::tip, width);
	}

	private static boolean isAtBorder(final List<Example> examples,
		final Function<Chain, Point> end, final double width) {
		final long near = examples.stream().filter(e -> {
			final Point at = end.apply(e.chain());
			return Math.min(Math.min(at.x(), e.frame().width() - 1 - at.x()),
				Math.min(at.y(), e.frame().height() - 1 - at.y())) < width;
		}).count();
		return 2 * near > examples.size();
	}
}
