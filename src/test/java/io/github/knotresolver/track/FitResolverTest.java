package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.Collectors;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.candidate.CandidateGenerator;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.contour.DiscreteFrechet;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.LengthModel;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

class FitResolverTest {

	private static final double LENGTH = 80;

	private static final LineModel LINE = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1);

	private static List<Observation> resolve(final List<FrameView> frames,
		final CandidateGenerator generator, final Chain first,
		final Map<Integer, Polyline> corrections) {
		try (Workers workers = new Workers(1)) {
			return new FitResolver(generator, EnumSet.of(LINE.kind()), LengthModel.AUTO, workers,
				Progress.NONE).learn(frames, first.start(), OptionalDouble.empty()).orElseThrow()
				.solve(Settings.DEFAULT.edit().corrections(corrections).build().constraints(),
					workers, Progress.NONE)
				.frames();
		}
	}

	private static void assertFollows(final List<Chain> truth, final List<Observation> found) {
		for (int t = 0; t < truth.size(); t++) {
			assertEquals(FrameStatus.RESOLVED, found.get(t).status(), "frame " + t);
			final double d = DiscreteFrechet.distance(truth.get(t).contour(),
				found.get(t).contour().orElseThrow());
			assertTrue(d < 4, "frame " + t + ": " + d + " px off");
		}
	}

	/** Proposes contours in some frames only, as if the others were one tangle. */
	private static CandidateGenerator only(final List<FrameView> seen) {
		final Set<SkeletonGraph> known = Collections.newSetFromMap(new IdentityHashMap<>());
		known.addAll(seen.stream().map(FrameView::graph).collect(Collectors.toList()));
		return (query, progress) -> known.contains(query.graph())
			? TrailCandidates.DEFAULT.generate(query, progress)
			: new CandidateSet(List.of(), false);
	}

	@ParameterizedTest
	@CsvSource({"0, 5", "7, 12"})
	void framesWithoutAnyProposalAreFollowedFromBothSides(final int from, final int to) {
		final List<Chain> truth = DrawnMovie.waves(12, LENGTH, 2.2);
		final List<FrameView> frames = DrawnFrames.of(truth, LINE, t -> 1);
		final List<FrameView> seen = new ArrayList<>(frames);
		seen.removeAll(frames.subList(from, to));
		assertFollows(truth, resolve(frames, only(seen), truth.get(0), Map.of()));
	}

	/** In the three frames that show it clearly something bright lies beyond its tip. */
	@Test
	void allFramesTellTheLengthWhereTheClearestAreTooLong() {
		final List<Chain> truth = DrawnMovie.waves(14, LENGTH, 1.2), drawn = new ArrayList<>(truth);
		for (int t = 0; t < 3; t++)
			drawn.set(t, truth.get(t).resized(1.04 * LENGTH));
		final List<FrameView> frames = DrawnFrames.of(drawn, LINE, t -> 1);
		final List<Observation> found = resolve(frames, only(frames.subList(0, 3)), truth.get(0),
			Map.of());
		for (int t = 3; t < truth.size(); t++)
			assertEquals(LENGTH, found.get(t).contour().orElseThrow().length(), 0.007 * LENGTH,
				"frame " + t);
	}

	/** In the three frames that show it clearly something as bright lies before its fixed end. */
	@Test
	void inNoiseTheContoursTellWhereTheClearestBeginTooEarly() {
		final List<Chain> truth = DrawnMovie.waves(14, LENGTH, 1.2);
		final LineTables line = LineTables.together(LINE);
		final Random random = new Random(7);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < truth.size(); t++)
			frames
				.add(DrawnFrames.lit(t + 1,
					DrawnFrames.light(DrawnMovie.SIZE, line,
						List.of(t < 3 ? begunEarlier(truth.get(t), 4) : truth.get(t))),
					0.45, random));
		final List<Observation> found = resolve(frames, only(frames.subList(0, 3)), truth.get(0),
			Map.of());
		final double[] off = found.subList(3, truth.size()).stream()
			.mapToDouble(f -> f.contour().orElseThrow().first().distanceTo(truth.get(0).start()))
			.toArray();
		assertTrue(RobustStatistics.median(off) < 1, Arrays.toString(off));
	}

	private static Chain begunEarlier(final Chain chain, final double by) {
		final List<Point> points = new ArrayList<>();
		points.add(new Point(chain.start().x() - by * Math.cos(chain.angle(0)),
			chain.start().y() - by * Math.sin(chain.angle(0))));
		for (int i = 0; i < chain.polyline().size(); i++)
			points.add(chain.polyline().point(i));
		return Chain.along(Polyline.of(points), chain.links(), chain.length() + by);
	}

	@ParameterizedTest
	@ValueSource(doubles = {0.15, 0.06, -0.08})
	void aFilamentThatFadesOrBrightensIsFollowedToTheEnd(final double rate) {
		final List<Chain> truth = DrawnMovie.waves(14, LENGTH, 1.2);
		final List<Observation> found = resolve(
			DrawnFrames.of(truth, LINE, t -> Math.exp(-rate * t)), TrailCandidates.DEFAULT,
			truth.get(0), Map.of());
		assertFollows(truth, found);
		assertTrue(found.stream().allMatch(f -> f.confidence() > 0.5),
			found.stream().map(f -> "" + f.confidence()).collect(Collectors.joining(" ")));
	}

	/** A loop through which the filament crosses itself at a right angle. */
	private static Chain loop(final double radius, final boolean reversed) {
		final List<double[]> inner = new ArrayList<>();
		for (int k = 0; k <= 27; k++) {
			final double a = Math.toRadians(90 - 10 * k);
			inner.add(new double[]{50 + radius + radius * Math.cos(a),
				60 - radius + radius * Math.sin(a)});
		}
		if (reversed)
			Collections.reverse(inner);
		final double[] xy = new double[2 * inner.size() + 6];
		xy[0] = 12;
		xy[1] = 60;
		xy[2] = 50;
		xy[3] = 60;
		for (int k = 0; k < inner.size(); k++)
			System.arraycopy(inner.get(k), 0, xy, 4 + 2 * k, 2);
		xy[xy.length - 2] = 50;
		xy[xy.length - 1] = 60 + 40;
		return Chain.along(Drawn.line(xy), 60, 130);
	}

	/** Quarter turns between beginning and end: three to one side, or one to the other. */
	private static long quarterTurns(final Polyline contour) {
		final Chain chain = Chain.along(contour, 60, contour.length());
		return Math.round((chain.angle(58) - chain.angle(1)) / (Math.PI / 2));
	}

	@Test
	void aContourThatIsGivenIsKeptAndDecidesItsNeighbours() {
		final List<Chain> truth = new ArrayList<>();
		for (int t = 0; t < 11; t++)
			truth.add(loop(14 + 0.2 * t, false));
		final List<FrameView> frames = DrawnFrames.of(truth, LINE, t -> 1);
		final List<Observation> free = resolve(frames, TrailCandidates.DEFAULT, truth.get(0),
			Map.of());
		for (final Observation f : free)
			assertEquals(-3, quarterTurns(f.contour().orElseThrow()), "free, frame " + f.frame());
		final Polyline before = loop(14.8, true).contour(), after = loop(15.2, true).contour();
		assertEquals(1, quarterTurns(before));
		final List<Observation> corrected = resolve(frames, TrailCandidates.DEFAULT, truth.get(0),
			Map.of(5, before, 7, after));
		for (int t = 4; t < 7; t++) {
			assertEquals(t == 5 ? FrameStatus.RESOLVED : FrameStatus.CORRECTED,
				corrected.get(t).status());
			assertEquals(1, quarterTurns(corrected.get(t).contour().orElseThrow()), "frame " + t);
		}
	}

	private static double worstStart(final List<Chain> truth, final List<Observation> found) {
		double worst = 0;
		for (int t = 0; t < truth.size(); t++)
			worst = Math.max(worst,
				found.get(t).contour().orElseThrow().first().distanceTo(truth.get(t).start()));
		return worst;
	}

	/** A stage that moves everything. */
	private static List<Chain> carried(final IntFunction<Point> stage) {
		final List<Chain> waves = DrawnMovie.waves(24, LENGTH, 2.4);
		final List<Chain> moved = new ArrayList<>();
		for (int t = 0; t < waves.size(); t++)
			moved.add(waves.get(t).shifted(stage.apply(t).x(), stage.apply(t).y()));
		return moved;
	}

	@Test
	void aClampThatDriftsIsFollowed() {
		final List<Chain> truth = carried(t -> new Point(0.5 * t, -0.3 * t));
		final List<Observation> found = resolve(DrawnFrames.of(truth, LINE, t -> 1),
			TrailCandidates.DEFAULT, truth.get(0), Map.of());
		assertFollows(truth, found);
		assertTrue(worstStart(truth, found) < 1, worstStart(truth, found) + " px");
	}

	@ParameterizedTest
	@ValueSource(ints = {1, 2, 9, 15, 20, 22, 23})
	void aClampThatJumpsIsFollowed(final int frame) {
		final List<Chain> truth = carried(t -> t < frame ? new Point(0, 0) : new Point(6, -7));
		final List<Observation> found = resolve(DrawnFrames.of(truth, LINE, t -> 1),
			TrailCandidates.DEFAULT, truth.get(0), Map.of());
		assertFollows(truth, found);
		assertTrue(worstStart(truth, found) < 1, worstStart(truth, found) + " px");
	}

	@ParameterizedTest
	@ValueSource(doubles = {1.2, -1})
	void aFilamentThatGrowsOrShrinksIsFollowedToItsTip(final double rate) {
		final List<Chain> truth = new ArrayList<>();
		for (int t = 0; t < 20; t++)
			truth.add(DrawnMovie.wave(t, 80, 1.5).resized(65 + rate * t));
		final List<Observation> found = resolve(DrawnFrames.of(truth, LINE, t -> 1),
			TrailCandidates.DEFAULT, truth.get(0), Map.of());
		assertFollows(truth, found);
		for (int t = 0; t < truth.size(); t++)
			assertEquals(truth.get(t).length(), found.get(t).contour().orElseThrow().length(), 1,
				"frame " + t);
	}

	/** Haze beyond its tip, which is the brighter the later. */
	@Test
	void aFilamentWhoseTipComesIntoHazeDoesNotGrow() {
		final List<Chain> truth = DrawnMovie.waves(14, LENGTH, 1.2);
		final LineTables line = LineTables.together(LINE);
		final Random random = new Random(7);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < truth.size(); t++) {
			final double[] light = DrawnFrames.light(DrawnMovie.SIZE, line, List.of(truth.get(t)));
			final double[] longer = DrawnFrames.light(DrawnMovie.SIZE, line,
				List.of(truth.get(t).resized(LENGTH + 6)));
			for (int i = 0; i < light.length; i++)
				light[i] += 0.5 * t / truth.size() * (longer[i] - light[i]);
			frames.add(DrawnFrames.lit(t + 1, light, 0.1, random));
		}
		final double[] lengths = resolve(frames, TrailCandidates.DEFAULT, truth.get(0), Map.of())
			.stream().mapToDouble(f -> f.contour().orElseThrow().length()).toArray();
		for (int t = 0; t < truth.size(); t++)
			assertEquals(lengths[0], lengths[t], 0.1, "frame " + t);
	}

	/** Out of its clamp into a ring, which turns, and on which it lies for more than a turn if long. */
	private static Chain ring(final double length, final double turned) {
		final List<Point> points = new ArrayList<>();
		for (double turn = 0; turn < 4 * Math.PI; turn += 0.02) {
			final double r = 18 * (1 - Math.exp(-turn / 0.7));
			points
				.add(new Point(55 + r * Math.cos(turn + turned), 55 + r * Math.sin(turn + turned)));
		}
		return Chain.along(Polyline.of(points).head(length), 60, length);
	}

	@Test
	void aFilamentThatGrowsWhileItLiesOnItselfIsFollowedToItsTip() {
		final List<Chain> truth = new ArrayList<>();
		for (int t = 0; t < 16; t++)
			truth.add(ring(112 + 4 * t, 0.12 * t));
		final List<Observation> found = resolve(DrawnFrames.of(truth, LINE, t -> 1),
			TrailCandidates.DEFAULT, truth.get(0), Map.of());
		assertFollows(truth, found);
		for (int t = 0; t < truth.size(); t++)
			assertEquals(truth.get(t).length(), found.get(t).contour().orElseThrow().length(), 1.5,
				"frame " + t);
	}

	@ParameterizedTest
	@ValueSource(ints = {8, 12})
	void aFilamentThatBreaksIsFollowedAcrossTheFrameOfTheBreak(final int frame) {
		final List<Chain> truth = new ArrayList<>();
		for (int t = 0; t < 20; t++)
			truth.add(DrawnMovie.wave(t, 90, 2.6).resized(t < frame ? 90 : 52));
		final List<Observation> found = resolve(DrawnFrames.of(truth, LINE, t -> 1),
			TrailCandidates.DEFAULT, truth.get(0), Map.of());
		for (int t = 0; t < truth.size(); t++)
			assertEquals(truth.get(t).length(), found.get(t).contour().orElseThrow().length(), 1,
				"frame " + t);
	}

	@Test
	void aFilamentThatLeavesThePictureEndsAtItsBorder() {
		final List<Chain> leaving = new ArrayList<>();
		for (int t = 0; t < 16; t++)
			leaving.add(DrawnMovie.wave(t, 80, 0.8).shifted(t < 6 ? 0 : 24, 0));
		final List<Observation> found = resolve(DrawnFrames.of(leaving, LINE, t -> 1),
			TrailCandidates.DEFAULT, leaving.get(0), Map.of());
		for (int t = 0; t < leaving.size(); t++) {
			final boolean inside = leaving.get(t).tip().x() < DrawnMovie.SIZE - 1;
			assertEquals(inside, found.get(t).visible() == 1, "frame " + t);
			assertEquals(leaving.get(t).length() * found.get(t).visible(),
				found.get(t).contour().orElseThrow().length(), 1.5, "frame " + t);
		}
	}
}
