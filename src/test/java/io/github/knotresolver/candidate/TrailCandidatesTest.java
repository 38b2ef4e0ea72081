package io.github.knotresolver.candidate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;

import org.jgrapht.alg.connectivity.ConnectivityInspector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.RootedGraph;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.graph.Step;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

class TrailCandidatesTest {

	private static final int WIDE = 1_000_000;

	private static CandidateSet trails(final SkeletonGraph graph, final Point fixedEnd,
		final double length) {
		return TrailCandidates.DEFAULT.generate(CandidateQuery.of(graph, fixedEnd,
			length > 0 ? OptionalDouble.of(length) : OptionalDouble.empty()), Progress.NONE);
	}

	private static SkeletonGraph drawn(final Polyline... curves) {
		return SkeletonGraph.of(Drawn.skeleton(140, 100, curves), 0, List.of());
	}

	private static Polyline spiral(final double turns, final int stem) {
		final List<Point> points = new ArrayList<>();
		for (int x = 0; x < stem; x++)
			points.add(new Point(50 + x, 50));
		for (int i = 0; i <= turns * 100; i++)
			points.add(new Point(50 + stem * Math.cos(i * Math.PI / 50),
				50 + stem * Math.sin(i * Math.PI / 50)));
		return Polyline.of(points);
	}

	private static void assertFollows(final Polyline truth, final Candidate candidate,
		final double tolerance) {
		assertFollows(truth, candidate, tolerance, "");
	}

	private static void assertFollows(final Polyline truth, final Candidate candidate,
		final double tolerance, final String what) {
		final Polyline path = candidate.path();
		assertEquals(truth.length(), path.length(), 0.05 * truth.length());
		for (double f = 0; f <= 1; f += 0.05) {
			final Point p = truth.at(f * truth.length()), q = path.at(f * path.length());
			assertTrue(p.distanceTo(q) <= tolerance,
				what + " at " + f + " of the length " + q + " should be " + p);
		}
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
	void wideBeamFindsWhatBruteForceFinds(final long seed) {
		final Random random = new Random(seed);
		final SkeletonGraph lattice = lattice(random);
		for (int trial = 0; trial < 3; trial++) {
			final OptionalDouble known = trial == 0
				? OptionalDouble.empty()
				: OptionalDouble.of(lattice.length() * (0.4 + 1.4 * random.nextDouble()));
			final Point fixedEnd = lattice.segments().get(0).chain().point(0);
			final RootedGraph rooted = RootedGraph.of(lattice, fixedEnd);
			final TrailOracle oracle = new TrailOracle(rooted.graph(), known,
				TrailCandidates.Prices.DEFAULT);
			final List<Double> expected = oracle.prices(rooted.roots().get(0), 2);
			final CandidateSet found = new TrailCandidates(40, WIDE, 2,
				TrailCandidates.Prices.DEFAULT)
				.generate(CandidateQuery.of(lattice, fixedEnd, known), Progress.NONE);
			assertFalse(found.limited());
			final String where = "seed " + seed + ", trial " + trial + ", " + expected.size()
				+ " trails";
			assertEquals(expected.get(0), found.candidates().get(0).price().total(), 1e-9, where);
			for (final Candidate c : found.candidates())
				assertEquals(oracle.price(c.steps(), c.end()), c.price().total(), 1e-9, where);
		}
	}

	@ParameterizedTest
	@ValueSource(longs = {21, 22, 23, 24})
	void searchGivesTheCheapestTrailsInOrder(final long seed) {
		final Random random = new Random(seed);
		final SkeletonGraph lattice = lattice(random);
		final OptionalDouble known = OptionalDouble
			.of(lattice.length() * (0.5 + random.nextDouble()));
		final RootedGraph rooted = RootedGraph.of(lattice,
			lattice.segments().get(0).chain().point(0));
		final TrailSearch search = new TrailSearch(rooted.graph(),
			new TrailPricing(TrailCandidates.Prices.DEFAULT, known, lattice.length()), 2, WIDE, 25);
		final List<Double> found = search.run(
			rooted.graph().stepsFrom(rooted.roots().get(0)).stream()
				.map(s -> Trail.along(s, rooted.graph().segments().size(), 0)).toList(),
			Progress.NONE).stream().map(c -> c.price().total()).toList();
		final List<Double> expected = new TrailOracle(rooted.graph(), known,
			TrailCandidates.Prices.DEFAULT).prices(rooted.roots().get(0), 2);
		assertEquals(Math.min(25, expected.size()), found.size());
		for (int i = 0; i < found.size(); i++)
			assertEquals(expected.get(i), found.get(i), 1e-9, "seed " + seed + ", trail " + i);
	}

	/** Lines between random lattice points, connected, of few segments. */
	private static SkeletonGraph lattice(final Random random) {
		while (true) {
			final List<Polyline> links = new ArrayList<>();
			for (int x = 0; x < 3; x++)
				for (int y = 0; y < 3; y++) {
					final double px = 10 + 14 * x, py = 10 + 18 * y;
					if (x < 2 && random.nextInt(10) < 6)
						links.add(Drawn.line(px, py, px + 14, py));
					if (y < 2 && random.nextInt(10) < 6)
						links.add(Drawn.line(px, py, px, py + 18));
				}
			final SkeletonGraph g = drawn(links.toArray(Polyline[]::new));
			final boolean connected = new ConnectivityInspector<>(g.asGraph()).isConnected();
			if (connected && g.segments().size() >= 3 && g.segments().size() <= 6)
				return g;
		}
	}

	@Test
	void unbranchedFilamentHasItselfFirst() {
		final Polyline line = Drawn.line(10, 10, 60, 30, 100, 10);
		assertFollows(line, trails(drawn(line), line.first(), line.length()).candidates().get(0),
			2);
	}

	@ParameterizedTest
	@CsvSource({"1.0", "1.3", "1.6"})
	void spiralOnItsOwnTrackUsesTheRingTwice(final double turns) {
		final Polyline truth = spiral(turns, 25);
		final CandidateSet set = trails(drawn(truth), truth.first(), truth.length());
		// A drawn spoke meets the ring at a right angle: both ways round cost the same.
		assertTrue(IntStream.range(0, 2).anyMatch(i -> {
			final Polyline path = set.candidates().get(i).path();
			return path.last().distanceTo(truth.last()) < 5
				&& path.at(50).distanceTo(truth.at(50)) < 5;
		}), "the truth is among the first two");
		assertEquals(truth.length(), set.candidates().get(0).length(), 1.5);
	}

	@Test
	void parallelOverlapIsWalkedTwice() {
		// From the left over the common strand, round the loop, back over it, and away.
		final Polyline truth = Drawn.line(10, 30, 40, 50, 70, 50, 95, 35, 115, 50, 95, 65, 70, 50,
			40, 50, 10, 70);
		final CandidateSet set = trails(drawn(truth), truth.first(), truth.length());
		final Candidate best = set.candidates().get(0);
		assertEquals(5, best.steps().size());
		assertTrue(best.price().overlap() > 2);
		assertEquals(0, best.price().uncovered(), 1e-6);
		assertTrue(best.path().last().distanceTo(truth.last()) < 2);
	}

	@ParameterizedTest
	@CsvSource({"95, crosses the stem", "75, just passes it", "60, lies on it"})
	void loopIsWalkedStraightThroughItsCrossing(final double tip, final String what) {
		final Polyline truth = loop(tip);
		assertFollows(truth,
			trails(drawn(truth), truth.first(), truth.length()).candidates().get(0), 5,
			"the tip " + what);
	}

	/** A stem to the right, a loop above it, and the tip coming down at x = 60. */
	private static Polyline loop(final double tip) {
		return Drawn.line(10, 60, 80, 60, 100, 40, 80, 20, 60, 40, 60, tip);
	}

	@Test
	void whatThinningHidesAtTheFixedEndCountsAsLength() {
		final Polyline truth = spiral(1.3, 25);
		final Candidate best = trails(drawn(truth), new Point(46, 50), truth.length()).candidates()
			.get(0);
		assertEquals(truth.length() - 4, best.length(), 1.5);
	}

	@Test
	void foreignFilamentIsLeftOut() {
		final Polyline truth = Drawn.line(10, 50, 120, 50);
		final CandidateSet set = trails(drawn(truth, Drawn.line(60, 10, 70, 90)), truth.first(),
			truth.length());
		assertFollows(truth, set.candidates().get(0), 3);
	}

	@Test
	void debrisIsLeftOut() {
		final Polyline truth = Drawn.line(10, 50, 120, 50);
		final CandidateSet set = trails(drawn(truth, Drawn.line(60, 50, 60, 58)), truth.first(),
			truth.length());
		assertFollows(truth, set.candidates().get(0), 2);
		assertEquals(8, set.candidates().get(0).price().uncovered(), 2);
	}

	@Test
	void severalLoopsAreUnwound() {
		final Polyline truth = Drawn.line(5, 70, 40, 70, 50, 55, 35, 40, 25, 55, 35, 75, 90, 75,
			105, 55, 90, 35, 75, 55, 85, 80, 130, 85);
		assertFollows(truth,
			trails(drawn(truth), truth.first(), truth.length()).candidates().get(0), 6);
	}

	@Test
	void smallLoopIsToldByTheLength() {
		final Polyline loop = Drawn.line(10, 50, 60, 50, 65, 45, 60, 40, 55, 45, 60, 50, 61, 50,
			120, 50);
		final SkeletonGraph g = drawn(loop);
		assertTrue(trails(g, loop.first(), loop.length()).candidates().get(0).steps().size() >= 3);
		assertEquals(2, trails(g, loop.first(), 110).candidates().stream()
			.filter(c -> c.price().uncovered() > 10).findFirst().orElseThrow().steps().size());
	}

	@Test
	void clampUnderAnotherStrandStartsInsideTheSegment() {
		final Polyline truth = Drawn.line(60, 50, 110, 50, 110, 20, 60, 20, 60, 90);
		final CandidateSet set = trails(drawn(truth), truth.first(), truth.length());
		assertTrue(set.candidates().stream().limit(3)
			.anyMatch(c -> c.path().last().distanceTo(truth.last()) < 3
				&& c.path().at(40).distanceTo(truth.at(40)) < 5));
	}

	@Test
	void withoutLengthEverythingIsCoveredOnce() {
		final Polyline truth = loop(95);
		final Candidate best = trails(drawn(truth), truth.first(), 0).candidates().get(0);
		assertFollows(truth, best, 5);
		assertEquals(0, best.price().lengthMisfit());
	}

	@Test
	void candidatesDiffer() {
		final Polyline truth = spiral(1.4, 25);
		final List<Polyline> ways = trails(drawn(truth), truth.first(), truth.length()).candidates()
			.stream().map(Likeness::sample).toList();
		assertTrue(ways.size() > 3);
		for (int i = 0; i < ways.size(); i++)
			for (int j = 0; j < i; j++)
				assertFalse(Likeness.alike(ways.get(i), ways.get(j)), i + " and " + j);
	}

	@Test
	void narrowBeamIsReported() {
		final Polyline truth = loop(95);
		final CandidateQuery query = CandidateQuery.of(drawn(truth), truth.first(),
			OptionalDouble.of(truth.length()));
		assertTrue(new TrailCandidates(40, 1, 2, TrailCandidates.Prices.DEFAULT)
			.generate(query, Progress.NONE).limited());
		assertFalse(TrailCandidates.DEFAULT.generate(query, Progress.NONE).limited());
	}

	@Test
	void emptyGraphHasNoCandidates() {
		assertTrue(trails(drawn(), new Point(1, 1), 100).candidates().isEmpty());
	}

	@Test
	void stepsAreConnectedAndNeverReverse() {
		final Polyline truth = spiral(1.4, 25);
		for (final Candidate c : trails(drawn(truth), truth.first(), truth.length()).candidates())
			for (int i = 1; i < c.steps().size(); i++) {
				final Step before = c.steps().get(i - 1), step = c.steps().get(i);
				assertEquals(before.to(), step.from());
				assertFalse(step.isReverseOf(before));
			}
	}

	@Test
	void cancelStopsTheSearch() {
		final Polyline truth = spiral(1.4, 25);
		final Progress stop = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
			}

			@Override
			public boolean isCancelled() {
				return true;
			}
		};
		assertThrows(CancelledException.class, () -> TrailCandidates.DEFAULT.generate(
			CandidateQuery.of(drawn(truth), truth.first(), OptionalDouble.empty()), stop));
	}

	@Test
	void badLimitsAreNamed() {
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> new TrailCandidates(40, 0, 2, TrailCandidates.Prices.DEFAULT)).getMessage()
			.contains("0"));
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> CandidateQuery.of(drawn(), new Point(0, 0), OptionalDouble.of(-3))).getMessage()
			.contains("-3.0"));
		assertThrows(IllegalArgumentException.class,
			() -> new TrailCandidates.Prices(-1, 1, 1, 1, 1));
	}
}
