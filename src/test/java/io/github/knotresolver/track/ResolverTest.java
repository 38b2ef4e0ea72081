package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.contour.DiscreteFrechet;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.paper.PaperCandidates;
import io.github.knotresolver.paper.PaperResolver;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

class ResolverTest {

	private static final Point FIXED = new Point(5, 60);

	private static final Polyline OPEN = Drawn.line(5, 60, 60, 60, 90, 40, 75, 12, 5, 8);

	private static final Resolver PAPER = new PaperResolver(PaperCandidates.DEFAULT);

	private static final Resolver MOVIE = new TrellisResolver(TrailCandidates.DEFAULT);

	/** The same filament with its tip laid across its stem. */
	private static Polyline knot(final double shift) {
		return Drawn.line(5, 60, 60, 60, 80 + shift, 40, 60 + shift, 18, 40, 40, 40 - shift, 85);
	}

	private static ResolverQuery query(final Polyline... truth) {
		final List<FrameGraph> frames = new ArrayList<>();
		for (final Polyline t : truth)
			frames.add(new FrameGraph(frames.size() + 1,
				t == null
					? Optional.empty()
					: Optional.of(SkeletonGraph.of(Drawn.skeleton(110, 100, t)))));
		return new ResolverQuery(frames, FIXED, OptionalDouble.empty(), Map.of());
	}

	private static void assertResolved(final Polyline truth, final Observation frame) {
		assertEquals(FrameStatus.RESOLVED, frame.status(), "frame " + frame.frame());
		assertEquals("", frame.reason());
		assertTrue(DiscreteFrechet.distance(truth.resampled(1), frame.contour().orElseThrow()) < 6,
			"frame " + frame.frame());
	}

	@Test
	void trellisResolvesKnottedFirstFrames() {
		final Polyline[] truth = {knot(0), knot(2), knot(4), OPEN, OPEN, OPEN};
		final Track track = MOVIE.resolve(query(truth), Progress.NONE);
		assertEquals(OPEN.length(), track.length(), 4);
		for (int t = 0; t < truth.length; t++)
			assertResolved(truth[t], track.frames().get(t));
		assertEquals(1, track.frames().get(0).junctions());
		assertEquals(1, track.frames().get(0).crossings());
		assertTrue(track.frames().get(0).candidates() > 1);
		assertTrue(
			track.frames().stream().allMatch(f -> f.confidence() > 0.3 && f.confidence() <= 1));
	}

	@Test
	void trellisFindsTheLengthOfAMovieThatIsAlwaysKnotted() {
		final Polyline[] truth = {knot(0), knot(1), knot(2), knot(3)};
		final Track track = MOVIE.resolve(query(truth), Progress.NONE);
		assertEquals(truth[1].length(), track.length(), 0.04 * truth[1].length());
		for (int t = 0; t < truth.length; t++)
			assertResolved(truth[t], track.frames().get(t));
	}

	@Test
	void toldLengthIsUsed() {
		final ResolverQuery q = query(OPEN, OPEN, OPEN);
		final Track track = MOVIE.resolve(
			new ResolverQuery(q.frames(), FIXED, OptionalDouble.of(170), Map.of()), Progress.NONE);
		assertEquals(170, track.length());
	}

	@Test
	void lostFramesAreBridged() {
		final Track track = MOVIE.resolve(query(OPEN, null, knot(0), OPEN, null, OPEN),
			Progress.NONE);
		assertEquals(FrameStatus.LOST, track.frames().get(1).status());
		assertEquals(FrameStatus.LOST, track.frames().get(4).status());
		assertResolved(knot(0), track.frames().get(2));
		assertEquals(FrameStatus.LOST,
			PAPER.resolve(query(OPEN, (Polyline) null), Progress.NONE).frames().get(1).status());
	}

	@Test
	void correctionIsAConstraintOnItsNeighbours() {
		// The user says that the tip runs the other way round the loop.
		final Polyline reversed = Drawn.line(5, 60, 40, 60, 40, 40, 60, 18, 80, 40, 60, 60, 40, 60,
			40, 85);
		final ResolverQuery q = query(knot(0), knot(0), knot(0));
		final Map<Integer, Polyline> both = Map.of(1, reversed, 3, reversed);
		final Track track = MOVIE.resolve(
			new ResolverQuery(q.frames(), FIXED, OptionalDouble.of(reversed.length()), both),
			Progress.NONE);
		assertEquals(FrameStatus.CORRECTED, track.frames().get(0).status());
		assertEquals(reversed, track.frames().get(0).contour().orElseThrow());
		assertResolved(reversed, track.frames().get(1));
		final Track free = MOVIE.resolve(
			new ResolverQuery(q.frames(), FIXED, OptionalDouble.of(reversed.length()), Map.of()),
			Progress.NONE);
		assertNotEquals(free.frames().get(1).contour(), track.frames().get(1).contour());
	}

	@Test
	void limitsAreTold() {
		final Resolver narrow = new TrellisResolver(
			new TrailCandidates(5, 1, 2, TrailCandidates.Prices.DEFAULT));
		final Track track = narrow.resolve(query(knot(0), OPEN, OPEN, OPEN), Progress.NONE);
		assertTrue(track.frames().get(0).reason().contains("limit"));
		assertEquals("", track.frames().get(1).reason());
	}

	@Test
	void sameResultOnAnyNumberOfThreads() {
		final ResolverQuery q = query(knot(0), knot(2), OPEN, OPEN, OPEN);
		final Track one = MOVIE.resolve(q, Progress.NONE);
		try (Workers workers = new Workers(4)) {
			assertEquals(one, new TrellisResolver(TrailCandidates.DEFAULT,
				TrellisResolver.DEFAULT_MOTION, workers).resolve(q, Progress.NONE));
		}
	}

	@Test
	void greedyNeedsAnUnbranchedFrameFirst() {
		final Polyline[] truth = {knot(0), knot(0), OPEN, knot(0)};
		final List<Observation> frames = PAPER.resolve(query(truth), Progress.NONE).frames();
		assertEquals(FrameStatus.UNRESOLVED, frames.get(0).status());
		assertTrue(frames.get(0).reason().contains("correct"));
		assertEquals(FrameStatus.UNRESOLVED, frames.get(1).status());
		assertResolved(OPEN, frames.get(2));
		assertEquals(FrameStatus.RESOLVED, frames.get(3).status());
		assertTrue(frames.get(3).cost() > 0);
		assertTrue(frames.get(3).candidates() > 1);
	}

	@Test
	void greedyGoesOnFromACorrection() {
		final ResolverQuery q = query(knot(0), knot(2), knot(4));
		final List<Observation> frames = PAPER.resolve(new ResolverQuery(q.frames(), FIXED,
			OptionalDouble.empty(), Map.of(1, knot(0).resampled(1))), Progress.NONE).frames();
		assertEquals(FrameStatus.CORRECTED, frames.get(0).status());
		assertResolved(knot(2), frames.get(1));
		assertResolved(knot(4), frames.get(2));
	}

	@Test
	void emptySkeletonIsUnresolved() {
		final ResolverQuery q = new ResolverQuery(
			List.of(new FrameGraph(1, Optional.of(SkeletonGraph.of(Drawn.skeleton(5, 5))))), FIXED,
			OptionalDouble.empty(), Map.of());
		assertEquals(FrameStatus.UNRESOLVED,
			MOVIE.resolve(q, Progress.NONE).frames().get(0).status());
		assertEquals(FrameStatus.UNRESOLVED,
			PAPER.resolve(q, Progress.NONE).frames().get(0).status());
	}

	@Test
	void badInputIsNamed() {
		assertThrows(IllegalArgumentException.class, () -> new FrameGraph(0, Optional.empty()));
		assertThrows(IllegalArgumentException.class,
			() -> new ResolverQuery(List.of(), FIXED, OptionalDouble.of(0), Map.of()));
	}
}
