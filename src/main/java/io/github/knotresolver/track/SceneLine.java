
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.SceneTrails;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineEstimator;
import io.github.knotresolver.fit.LineEstimator.Example;
import io.github.knotresolver.fit.LineEstimator.LineEstimate;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * What a line looks like in a movie with several filaments: learned from the frames whose
 * trails lie open.
 *
 * @param tables the line
 * @param frames all frames, their light in strands
 * @param noise of a pixel in strands, the median over frames
 */
record SceneLine(LineTables tables, List<FrameView> frames, double noise) {

	/** The median brightness of a curve, in the frame's units. */
	static double brightness(final NormalizedFrame light, final Polyline curve) {
		final int rim = curve.size() > 4 * SceneTuning.LINE_RIM ? SceneTuning.LINE_RIM : 0;
		final double[] values = IntStream.range(rim, curve.size() - rim)
			.mapToDouble(i -> light.meanAround(curve.x(i), curve.y(i))).filter(Double::isFinite)
			.toArray();
		return RobustStatistics.upperMedian(values, 0) / SceneTuning.MEAN_OF_RIDGE;
	}

	/**
	 * Learns the line.
	 *
	 * @param frames the movie, at least one frame with a trail
	 * @param kinds how strands may add up
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	static SceneLine learn(final List<FrameView> frames, final Collection<LineModel.Kind> kinds,
		final Workers workers, final Progress progress) {
		final double strand = firstStrand(frames);
		final List<FrameView> scaled = Calming.of(frames, strand, workers).stream()
			.map(f -> f.scaled(strand)).toList();
		final List<Seen> seen = look(scaled);
		final List<FrameView> open = best(seen,
			Comparator.comparingInt(s -> s.loose + s.crossings));
		final List<FrameView> crossed = best(seen.stream().filter(s -> s.crossings > 0).toList(),
			Comparator.comparingInt(Seen::loose)
				.thenComparing(Comparator.comparingInt(Seen::crossings).reversed()));
		final LineEstimate line = learn(new Looks(seen.stream().map(Seen::frame).toList(), open,
			crossed.isEmpty() ? open : crossed), kinds, progress);
		final List<FrameView> known = scaled.stream()
			.map(f -> f.rescaled(line.background(), line.amplitude())).toList();
		final double[] noise = known.stream().mapToDouble(f -> f.light().noise()).sorted()
			.toArray();
		return new SceneLine(LineTables.together(line.model()), known, noise[noise.length / 2]);
	}

	/** Length in pixels of which a filament is at least; what is shorter is a speck. */
	double shortestFilament() {
		return Specks.shortestFilament(tables().model().sigma());
	}

	/** About how bright a strand is above the background, in the frames' units. */
	static double firstStrand(final List<FrameView> frames) {
		final int stride = 1 + (frames.size() - 1) / SceneTuning.LINE_LOOKS;
		final double[] values = IntStream.range(0, frames.size()).filter(t -> t % stride == 0)
			.mapToObj(frames::get)
			.flatMapToDouble(f -> f.graph().segments().stream()
				.flatMapToDouble(s -> IntStream.range(0, s.curve().size())
					.mapToDouble(i -> f.light().meanAround(s.curve().x(i), s.curve().y(i)))))
			.filter(Double::isFinite).sorted().toArray();
		return values.length == 0
			? 1
			: Math.max(1e-9, values[(int) (SceneTuning.STRAND_QUANTILE * (values.length - 1))]
				/ SceneTuning.MEAN_OF_RIDGE);
	}

	/** A frame and how its trails look. */
	private record Seen(FrameView frame, int loose, int crossings, double length) {
	}

	private static List<Seen> look(final List<FrameView> frames) {
		final int stride = 1 + (frames.size() - 1) / SceneTuning.LINE_LOOKS;
		final List<Seen> seen = new ArrayList<>();
		for (int t = 0; t < frames.size(); t += stride) {
			final SceneTrails.Found found = SceneSeeder.trails(frames.get(t));
			final double length = found.curves().stream().mapToDouble(Polyline::length).sum();
			if (length > 0)
				seen.add(new Seen(frames.get(t), found.loose(), found.crossings(), length));
		}
		return seen;
	}

	/** The first frames in an order, of equal ones those with more to see. */
	private static List<FrameView> best(final List<Seen> seen, final Comparator<Seen> order) {
		return seen.stream()
			.sorted(order.thenComparing(Comparator.comparingDouble(Seen::length).reversed()))
			.limit(SceneTuning.LINE_FRAMES).map(Seen::frame).toList();
	}

	/** Frames that were looked at, those that lie most open, and those with most crossings. */
	private record Looks(List<FrameView> all, List<FrameView> open, List<FrameView> crossed) {
	}

	/**
	 * The line, and whether it adds up. Where it saturates, ends may be blunt, or blurred by a
	 * lens: open frames tell.
	 */
	private static LineEstimate learn(final Looks looks, final Collection<LineModel.Kind> kinds,
		final Progress progress) {
		if (!kinds.contains(LineModel.Kind.SATURATING))
			return learn(looks.open, LineModel.Kind.ADDITIVE, progress);
		final Optional<LineEstimate> additive = kinds.contains(LineModel.Kind.ADDITIVE)
			? Optional.of(learn(looks.open, LineModel.Kind.ADDITIVE, progress))
			: Optional.empty();
		final List<FrameView> scaled = additive.map(
			l -> looks.all.stream().map(f -> f.rescaled(l.background(), l.amplitude())).toList())
			.orElse(List.of());
		final OptionalDouble crossings = CrossingLight.of(scaled);
		if (crossings.isPresent() && crossings.getAsDouble() > SceneTuning.CROSSING_DOUBLE)
			return additive.get();
		final LineEstimate blunt = learn(looks.open, LineModel.Kind.SATURATING, progress);
		final LineEstimate blurred = learn(looks.open, LineModel.Kind.BRIGHTEST, progress);
		final LineEstimate saturating = blurred.residual() < blunt.residual() ? blurred : blunt;
		// Without crossings, light adds up where a lens blurs the ends.
		final LineEstimate rival = crossings.isPresent() ? saturating : blunt;
		// Strands meet, and nothing is as bright as two: it must be told clearly that light adds up.
		final double share = crossings.isPresent()
			&& CrossingLight.brightest(scaled) <= SceneTuning.CROSSING_DOUBLE
				? SceneTuning.VISIBLY_LESS
				: 1;
		return additive.filter(a -> doubt(a, looks.crossed) <= share * doubt(rival, looks.crossed))
			.orElse(saturating);
	}

	private static LineEstimate learn(final List<FrameView> frames, final LineModel.Kind kind,
		final Progress progress) {
		LineEstimate line = new LineEstimate(LineModel.uniform(kind, SceneTuning.FIRST_SIGMA, 1), 1,
			0, 1, 0, 1);
		for (int round = 0; round < SceneTuning.LINE_ROUNDS; round++) {
			final List<Example> examples = examples(frames, line);
			if (examples.isEmpty())
				return line;
			final LineEstimate next = LineEstimator.estimate(examples, kind, line.model().sigma(),
				l -> l.misfit(examples), progress);
			if (!next.isLine())
				return line;
			line = next;
		}
		return line;
	}

	/** The frames with all chains fitted to them. */
	private static List<Example> examples(final List<FrameView> frames, final LineEstimate line) {
		final LineTables tables = LineTables.together(line.model());
		final List<Example> examples = new ArrayList<>();
		for (final FrameView frame : frames) {
			final Scene scene = new Scene(
				frame.light().rescaled(line.background(), line.amplitude()), tables,
				SceneSeeder.starts(frame));
			new JointFit(scene, SceneWeights.DEFAULT).sweep(SceneTuning.LINE_SWEEPS);
			final List<Chain> chains = scene.chains();
			if (!chains.isEmpty())
				examples.add(new Example(frame.light(), chains));
		}
		return examples;
	}

	/** What a line leaves unexplained where strands cross: there kinds differ most. */
	private static double doubt(final LineEstimate line, final List<FrameView> crossed) {
		final List<Example> examples = examples(crossed, line);
		return examples.isEmpty()
			? line.residual()
			: LineEstimator.fit(examples, line.model()).residual();
	}

	/**
	 * @param t index of a frame
	 * @return how long a filament is that shines as much as all objects of the frame
	 */
	double lengthOfLight(final int t) {
		final FrameView frame = frames.get(t);
		final boolean[] near = near(t);
		final double[] pixels = frame.light().pixels();
		double sum = 0;
		for (int i = 0; i < near.length; i++)
			if (near[i])
				sum += pixels[i];
		return sum / (tables.model().sigma() * Math.sqrt(2 * Math.PI));
	}

	/** A frame with chains drawn in it. */
	Scene scene(final int t, final List<Chain> chains) {
		return new Scene(frames.get(t).light(), tables, chains);
	}

	/** What chains leave of a frame's light, or explain too much, in strands squared. */
	double left(final int t, final List<Chain> chains) {
		final Scene scene = scene(t, chains);
		return left(t, scene, new Unexplained(scene, noise));
	}

	/** The same, where what they leave is known pixel by pixel. */
	double left(final int t, final Scene scene, final Unexplained unexplained) {
		return unexplained.within(scene.near(near(t)));
	}

	/** The pixels of a frame in and around its objects. */
	boolean[] near(final int t) {
		return around(Pixels.bits(frames.get(t).mask()), frames.get(t).light().width());
	}

	/** The pixels near a set pixel, across and down. */
	private static boolean[] around(final boolean[] set, final int width) {
		final boolean[] near = new boolean[set.length];
		final int height = set.length / width;
		for (int i = 0; i < set.length; i++)
			if (set[i])
				for (int y = Math.max(0, i / width - SceneTuning.LINE_NEAR); y <= Math
					.min(height - 1, i / width + SceneTuning.LINE_NEAR); y++)
					for (int x = Math.max(0, i % width - SceneTuning.LINE_NEAR); x <= Math
						.min(width - 1, i % width + SceneTuning.LINE_NEAR); x++)
						near[y * width + x] = true;
		return near;
	}
}
