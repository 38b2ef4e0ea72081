package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import java.util.function.Supplier;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

/**
 * A whole line that lies still while others move over it, so that its light is known.
 *
 * @param chain its shape
 * @param line what it looks like
 * @param picture what it looks like in a frame, in strands
 * @param amplitude its brightness in the frames' units
 * @param light along it in the still picture, in the same units, so that it is as bright as that
 */
record StillLine(Chain chain, LineTables line, NormalizedFrame picture, double amplitude,
	double[] light) {

	/**
	 * A line in the still picture of a movie; its brightness is that in most frames.
	 *
	 * @param chain its shape
	 * @param line what a line looks like there
	 * @param still the still picture
	 * @param frames the movie
	 */
	static StillLine of(final Chain chain, final LineTables line, final NormalizedFrame still,
		final List<FrameView> frames) {
		final double[] light = along(still, chain);
		final NormalizedFrame picture = new NormalizedFrame(still.width(), still.height(),
			new Scene(still, line, List.of(chain)).picture());
		final double[] drawn = along(picture, chain);
		final double[] ratios = frames.stream()
			.mapToDouble(f -> usual(each(along(f.light(), chain), drawn, (a, b) -> a / b)))
			.toArray();
		final double amplitude = RobustStatistics.upperMedian(ratios, 0);
		final double dimmed = usual(each(light, drawn, (a, b) -> a / b));
		return new StillLine(chain, line, picture, amplitude,
			Arrays.stream(light).map(l -> l * amplitude / dimmed).toArray());
	}

	/** The light of a frame at the nodes of a chain but its ends. */
	private static double[] along(final NormalizedFrame frame, final Chain chain) {
		final Polyline curve = chain.polyline();
		return IntStream.range(1, curve.size() - 1)
			.mapToDouble(i -> frame.meanAround(curve.x(i), curve.y(i))).toArray();
	}

	private static double[] each(final double[] a, final double[] b,
		final DoubleBinaryOperator value) {
		return IntStream.range(0, a.length).mapToDouble(i -> value.applyAsDouble(a[i], b[i]))
			.filter(Double::isFinite).toArray();
	}

	/** The mean of those near a low quantile: others may lie along more than half of a line. */
	private static double usual(final double[] values) {
		final double[] sorted = Arrays.stream(values).sorted().toArray();
		if (sorted.length == 0)
			return 0;
		final double low = sorted[(int) (SceneTuning.STRAND_QUANTILE * (sorted.length - 1))];
		return Arrays.stream(sorted)
			.filter(v -> Math.abs(v - low) <= SceneTuning.STILL_CHANGES * Math.abs(low)).average()
			.orElse(low);
	}

	/** Whether it shines in a frame as it does in most. */
	boolean isIn(final FrameView frame) {
		return Math.abs(usual(each(along(frame.light(), chain), light, (a, b) -> a / b))
			- 1) <= SceneTuning.STILL_CHANGES;
	}

	/**
	 * Whether something lies over it in a frame, and its light adds to the line's own.
	 *
	 * @param strand about how bright others are, in the frames' units
	 */
	boolean isPassed(final FrameView frame, final double strand) {
		final double least = Math.max(SceneTuning.STILL_NOISES * frame.light().noise(),
			SceneTuning.STILL_PASSED * SceneTuning.MEAN_OF_RIDGE * strand);
		return Arrays.stream(each(along(frame.light(), chain), light, (a, b) -> a - b))
			.anyMatch(more -> more > least);
	}

	/** A frame without its light; as it is if the line is not in it. */
	FrameView takenOff(final FrameView frame) {
		if (!isIn(frame))
			return frame;
		final FrameView rest = SceneRemainder.of(frame.scaled(amplitude), line, List.of(chain));
		return new FrameView(frame.frame(), NormalizedFrame.of(frame.light().width(),
			frame.light().height(), (Supplier<float[]>) () -> left(frame.light())), rest.mask(),
			rest.graph());
	}

	/** Made whenever it is asked for, so that it takes no more memory than the frames do. */
	private float[] left(final NormalizedFrame light) {
		final double[] all = light.pixels(), own = picture.pixels();
		final float[] left = new float[all.length];
		for (int i = 0; i < left.length; i++)
			left[i] = (float) (all[i] - amplitude * own[i]);
		return left;
	}

	/**
	 * The line as a filament of which nothing says that an end is held.
	 *
	 * @param frames the movie
	 */
	SceneTracks.Filament filament(final List<FrameView> frames) {
		final List<Observation> observed = new ArrayList<>();
		for (final FrameView frame : frames)
			observed.add(isIn(frame)
				? new Observation(frame.frame(), FrameStatus.RESOLVED, "",
					Optional.of(chain.contour()), frame.graph().junctions(), 1, 0,
					1 - SceneConfidence.dark(frame.scaled(amplitude).light(), chain))
					.withVisible(SceneConfidence.visible(frame.light(), chain))
				: Observation.without(frame.frame(), FrameStatus.LOST,
					"This line lies still in other frames, but is not as bright in this one."));
		return new SceneTracks.Filament(false, false, chain.length(), Double.NaN, observed);
	}
}
