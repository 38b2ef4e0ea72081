package io.github.knotresolver.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.LineEstimator.Example;
import io.github.knotresolver.fit.LineEstimator.LineEstimate;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * Learns the line model, the filament's length and its fixed end from frames in
 * which the contour is beyond doubt. Line and curves are estimated in turns: the
 * line along the present curves, then the curves, both ends free, with that line.
 */
public final class FilamentEstimator {

	/** A clipped line explains all but this share of the pixels' variance, or is none that adds up. */
	private static final double WELL = 0.15;

	private FilamentEstimator() {
	}

	/**
	 * A frame and the contour that its skeleton gives.
	 *
	 * @param frame the frame
	 * @param contour fixed end first, in pixels
	 * @param others other ways through the skeleton, where parts of the filament seem to lie on
	 *          each other: there a contour may take the wrong way, and end where it runs into
	 *          itself; none if the filament lies open
	 */
	public record Sighting(NormalizedFrame frame, Polyline contour, List<Polyline> others) {

		public Sighting {
			others = List.copyOf(others);
		}

		/**
		 * @param frame a frame in which the filament lies open
		 * @param contour fixed end first, in pixels
		 */
		public Sighting(final NormalizedFrame frame, final Polyline contour) {
			this(frame, contour, List.of());
		}
	}

	/**
	 * @param sightings at least one; those that are clearest first
	 * @param kinds how strands may add up; the kind that explains the sightings best is
	 *          taken
	 * @param endsFree weights of a fit with both ends and the length free
	 * @param workers threads
	 * @param progress asked whether to stop
	 * @return what they say together; empty if what they show is no line that is brighter
	 *         than its surroundings
	 */
	public static Optional<FilamentEstimate> estimate(final List<Sighting> sightings,
		final Collection<LineModel.Kind> kinds, final FitSettings endsFree, final Workers workers,
		final Progress progress) {
		final List<Example> seen = new ArrayList<>();
		for (final Sighting s : sightings)
			seen.add(new Example(s.frame, chain(s.contour)));
		final Fitting fitting = new Fitting(sightings, endsFree, workers, progress);
		final List<Learned> learned = kinds.stream().map(kind -> {
			final Learned first = learn(seen, kind, fitting);
			return fitting.isOpen() ? first : ended(first, fitting);
		}).toList();
		// A profile along it changes nothing of what lines are compared by.
		return learned.stream().filter(Learned::isLine)
			.filter(l -> kinds.size() == 1 || l.isPlausible())
			.min(Comparator.comparingDouble(Learned::misfit))
			.map(l -> evenOrNot(l, fitting.released()))
			.map(l -> OneLength.of(l.summary(), l.line, l.examples, endsFree, workers, progress))
			.map(e -> e.orGuessed(!fitting.isOpen() && sightings.size() < FitTuning.FEWEST_CLOSED));
	}

	/**
	 * How curves are fitted.
	 *
	 * @param sightings where they come from
	 * @param endsFree weights of a fit with both ends and the length free
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	private record Fitting(List<Sighting> sightings, FitSettings endsFree, Workers workers,
		Progress progress) {

		boolean isOpen() {
			return sightings.stream().allMatch(s -> s.others.isEmpty());
		}

		/** The same, no start held. */
		Fitting released() {
			return new Fitting(
				sightings.stream().map(s -> new Sighting(s.frame, s.contour)).toList(), endsFree,
				workers, progress);
		}

		/**
		 * Where a filament lies on itself, one that is bent easily or is too stiff slips off its
		 * own end and onto another strand of itself; its start is held near the skeleton's there.
		 */
		private Optional<Point> start(final int i) {
			return isOpen() ? Optional.empty() : Optional.of(sightings.get(i).contour.first());
		}

		/** Fits the examples again; those that come from skeletons first as stiff filaments. */
		List<Example> again(final List<Example> examples, final LineEstimate line,
			final boolean fromSkeletons) {
			return workers.map(examples.size(), i -> {
				progress.checkCancelled();
				final Example e = examples.get(i);
				final NormalizedFrame frame = line.scaled(e);
				final Chain begin = fromSkeletons
					? fit(frame, line, e.chain(), start(i), stiff()).chain()
					: e.chain();
				return new Example(e.frame(), fit(frame, line, begin, start(i), endsFree).chain());
			});
		}

		/**
		 * The examples with the light that goes on beyond an end in most of them, dim as it may be.
		 * In frames that were blurred, noise looks like light; and how blunt the end of a line is whose
		 * light does not add up is not known.
		 */
		List<Example> towardsLight(final List<Example> examples, final LineEstimate line) {
			return line.model().kind() != LineModel.Kind.ADDITIVE
				|| examples.size() < FitTuning.FEWEST_TAPERS || endsFree.isNoisy()
					? examples
					: new TaperedEnds(line, workers).grown(examples);
		}

		private FitSettings stiff() {
			return endsFree.roughAndStiff(FitSettings.START_STIFFNESS);
		}

		/** All ways through each skeleton, fitted from there. */
		List<List<Chain>> ways(final List<Example> examples, final LineEstimate line) {
			return workers.map(examples.size(), i -> {
				progress.checkCancelled();
				final NormalizedFrame frame = line.scaled(examples.get(i));
				final List<Chain> ways = new ArrayList<>(List.of(examples.get(i).chain()));
				for (final Polyline other : sightings.get(i).others)
					ways.add(
						fit(frame, line, fit(frame, line, chain(other), start(i), stiff()).chain(),
							start(i), endsFree).chain());
				return ways;
			});
		}

		/**
		 * The ways through each skeleton followed to the end of their light: first the one that
		 * explains most, then those that differ from it and are hardly dearer.
		 */
		List<List<Chain>> toTheEnd(final List<Example> examples, final List<List<Chain>> ways,
			final LineEstimate line) {
			return workers.map(ways.size(), i -> {
				progress.checkCancelled();
				final NormalizedFrame frame = line.scaled(examples.get(i));
				final EndLight ends = new EndLight(frame, line.model(), frame.noise());
				return worthwhile(ways.get(i).stream()
					.map(w -> fit(frame, line, ends.settled(w), start(i), endsFree))
					.sorted(Comparator.comparingDouble(Fit::energy)).toList());
			});
		}

		private static List<Chain> worthwhile(final List<Fit> cheapestFirst) {
			final Fit best = cheapestFirst.get(0);
			final int links = best.chain().links();
			final List<Chain> kept = new ArrayList<>(List.of(best.chain()));
			for (final Fit f : cheapestFirst)
				if (f.energy() < best.energy() + FitTuning.OTHER_WAY && kept.stream().noneMatch(
					k -> f.chain().divided(links).distance(k.divided(links)) < FitTuning.SAME_WAY))
					kept.add(f.chain());
			return kept;
		}

		private static Fit fit(final NormalizedFrame frame, final LineEstimate line,
			final Chain start, final Optional<Point> hold, final FitSettings settings) {
			return new FilamentFitter(frame, line.model(), start.links(), hold,
				hold.isPresent() ? settings.withClampWeight(FitTuning.START_HELD) : settings)
				.fit(start, Optional.empty());
		}
	}

	/** A line and the curves that were fitted with it; whether their ends are a guess. */
	private record Learned(List<Example> examples, LineEstimate line, boolean guessed) {

		Learned(final List<Example> examples, final LineEstimate line) {
			this(examples, line, false);
		}

		boolean isLine() {
			return FilamentEstimator.isLine(line);
		}

		/**
		 * A line that is not clipped and yet saturates is flat on top; where it is not, the
		 * light is that of a lens, which adds up. What is above the ceiling of clipped frames is
		 * believed only if all that is below is explained well.
		 */
		boolean isPlausible() {
			final boolean additive = line.model().kind() == LineModel.Kind.ADDITIVE;
			return LineEstimator.isClipped(examples)
				? !additive || line.unexplained() < WELL
				: additive || line.model().power() > FitTuning.FLAT_POWER;
		}

		double misfit() {
			return line.misfitBesidesNoise(examples);
		}

		FilamentEstimate summary() {
			return FilamentEstimator.summary(examples, line, guessed);
		}
	}

	private static Learned learn(final List<Example> seen, final LineModel.Kind kind,
		final Fitting fitting) {
		List<Example> examples = seen;
		LineEstimate line = line(examples, kind, FitTuning.FIRST_WIDTH, fitting.progress);
		for (int round = 0; round < FitTuning.LINE_ROUNDS && line.isVisible(); round++) {
			examples = fitting.again(examples, line, round == 0);
			line = line(examples, kind, line.model().sigma(), fitting.progress);
		}
		return new Learned(examples, line);
	}

	/**
	 * Contours that may take a wrong way and end where the filament runs into itself, followed to
	 * the end of their light. All of the filament is taken for equally bright as long as that is
	 * not done: what is twice as bright are two strands.
	 */
	private static Learned ended(final Learned first, final Fitting fitting) {
		List<Example> examples = first.examples;
		LineEstimate line = first.line;
		List<List<Chain>> ways = isLine(line) ? fitting.ways(examples, line) : List.of();
		for (int round = 0; round < FitTuning.ENDING_ROUNDS && isLine(line); round++) {
			ways = fitting.toTheEnd(examples, ways, line);
			examples = along(examples, ways);
			line = line(examples, line.model().kind(), line.model().sigma(), fitting.progress);
		}
		return new Learned(fitting.released().again(examples, line, false), line);
	}

	/** The same frames with the first way through each. */
	private static List<Example> along(final List<Example> examples, final List<List<Chain>> ways) {
		return IntStream.range(0, ways.size())
			.mapToObj(i -> new Example(examples.get(i).frame(), ways.get(i).get(0))).toList();
	}

	/**
	 * The same with what the brightness is along the filament, if that is noticeable. Where the
	 * filament would be all but dark and bright again before its end, what lies beyond is something
	 * else: curves that followed it there are taken back. Where the ends do not settle, they are a
	 * guess.
	 */
	private static Learned evenOrNot(final Learned first, final Fitting fitting) {
		List<Example> examples = first.examples;
		LineEstimate line = first.line;
		for (int round = 0; round < FitTuning.MOST_PROFILE_ROUNDS; round++) {
			final List<Example> grown = fitting.towardsLight(examples, line);
			final double[] brightness = BrightnessProfile.estimate(grown, line);
			if (brightness.length == 1)
				return new Learned(examples, line);
			if (BrightnessProfile.isBroken(brightness))
				return new Learned(first.examples,
					first.line.withModel(first.line.model()
						.withBrightness(BrightnessProfile.estimate(first.examples, first.line))),
					true);
			line = OneLength.fading(line, brightness, grown, fitting.progress);
			final double before = usualLength(examples);
			examples = fitting.again(grown, line, false);
			if (round + 1 >= FitTuning.FEWEST_PROFILE_ROUNDS
				&& Math.abs(usualLength(examples) / before - 1) < FitTuning.PROFILE_SETTLED)
				return withoutHaze(
					new Learned(examples, line,
						BrightnessProfile.hasBrightEnd(brightness, usualLength(examples))),
					fitting);
		}
		return new Learned(examples, line, true);
	}

	/**
	 * The same without what lies beyond an end that fades within a few line widths: curves were led
	 * on into haze there. Where that goes on to the border of the picture, the ends are a guess.
	 */
	private static Learned withoutHaze(final Learned learned, final Fitting fitting) {
		final FadedEnds ends = FadedEnds.of(learned.line.model(), usualLength(learned.examples));
		if (ends.areNone())
			return learned;
		final List<Example> shorter = ends.cutFrom(learned.examples);
		final LineEstimate line = learned.line.withModel(
			learned.line.model().withBrightness(BrightnessProfile.estimate(shorter, learned.line)));
		return new Learned(fitting.again(shorter, line, false), line,
			learned.guessed || ends.areAtBorder(learned.examples, learned.line.model().sigma()));
	}

	private static boolean isLine(final LineEstimate line) {
		return line.isLine() && line.residual() < 1;
	}

	private static double usualLength(final List<Example> examples) {
		return RobustStatistics
			.median(examples.stream().mapToDouble(e -> e.chain().length()).toArray());
	}

	private static LineEstimate line(final List<Example> examples, final LineModel.Kind kind,
		final double sigma, final Progress progress) {
		final List<Example> clearest = examples.subList(0,
			Math.min(FitTuning.LINE_EXAMPLES, examples.size()));
		return LineEstimator.estimate(clearest, kind, sigma, l -> l.misfitBesidesNoise(clearest),
			progress);
	}

	private static Chain chain(final Polyline contour) {
		return Chain.along(contour, links(contour.length()), contour.length());
	}

	/**
	 * Fits a curve that comes from a skeleton, both ends and the length free: first as a
	 * stiff filament, since a skeleton has kinks that an easily bent one would keep.
	 *
	 * @param frame the frame, a strand's brightness 1
	 * @param model what a line looks like
	 * @param start the skeleton's curve
	 * @param endsFree weights of a fit with both ends and the length free
	 * @return the chain as fitted
	 */
	public static Chain fromSkeleton(final NormalizedFrame frame, final LineModel model,
		final Chain start, final FitSettings endsFree) {
		return endsFree(frame, model,
			endsFree(frame, model, start, endsFree.roughAndStiff(FitSettings.START_STIFFNESS)),
			endsFree);
	}

	private static Chain endsFree(final NormalizedFrame frame, final LineModel model,
		final Chain start, final FitSettings settings) {
		return new FilamentFitter(frame, model, start.links(), Optional.empty(), settings)
			.fit(start, Optional.empty()).chain();
	}

	private static FilamentEstimate summary(final List<Example> examples, final LineEstimate line,
		final boolean guessed) {
		final double[] lengths = examples.stream().mapToDouble(e -> e.chain().length()).toArray();
		final double middle = RobustStatistics.median(lengths);
		final double[] good = Arrays.stream(lengths)
			.filter(l -> Math.abs(l / middle - 1) < FitTuning.LENGTH_OUTLIER).toArray();
		final double length = good.length == 0 ? middle : RobustStatistics.median(good);
		final double[] off = Arrays.stream(good).map(l -> Math.abs(l - length)).toArray();
		final double error = good.length < FitTuning.FEWEST_VOTES
			? Double.NaN
			: RobustStatistics.MAD_TO_SD * RobustStatistics.median(off)
				* RobustStatistics.MEDIAN_TO_MEAN_ERROR / Math.sqrt(good.length);
		final double x = RobustStatistics
			.median(examples.stream().mapToDouble(e -> e.chain().start().x()).toArray());
		final double y = RobustStatistics
			.median(examples.stream().mapToDouble(e -> e.chain().start().y()).toArray());
		return new FilamentEstimate(line.model(), line.amplitude(), length, error, new Point(x, y),
			guessed);
	}

	/**
	 * @param length of a filament in pixels
	 * @return how many links it is given: about 3 px each, but never fewer than 45:
	 *         a polygon whose links are long for its bends is longer than the curve
	 */
	public static int links(final double length) {
		return Math.max(FitTuning.CLAMPED_LINKS, (int) Math.rint(length / FitTuning.LINK));
	}
}
