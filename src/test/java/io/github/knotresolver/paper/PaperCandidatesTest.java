package io.github.knotresolver.paper;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;

import org.jgrapht.Graph;
import org.jgrapht.alg.shortestpath.AllDirectedPaths;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.FilamentDigraph;
import io.github.knotresolver.graph.FilamentDigraph.Contact;
import io.github.knotresolver.graph.FilamentDigraph.Label;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.progress.Progress;

class PaperCandidatesTest {

	private static final Polyline LOOP = Drawn.line(2, 60, 40, 60, 55, 45, 40, 30, 25, 45, 40, 60,
		75, 60);

	private static SkeletonGraph drawn(final Polyline... curves) {
		return SkeletonGraph.of(Drawn.skeleton(140, 100, curves), 0, List.of());
	}

	private static CandidateSet paper(final SkeletonGraph graph, final Point fixedEnd,
		final Polyline template) {
		return PaperCandidates.DEFAULT.generate(new CandidateQuery(graph, fixedEnd,
			OptionalDouble.empty(), Optional.ofNullable(template)), Progress.NONE);
	}

	@Test
	void unbranchedFilamentIsItsOnlyCandidate() {
		final Polyline line = Drawn.line(10, 10, 100, 40);
		final CandidateSet set = paper(drawn(line), line.first(), line);
		assertEquals(1, set.candidates().size());
		assertEquals(line.last(), set.candidates().get(0).path().last());
	}

	@Test
	void loopIsWalkedBothWaysAndLeftOut() {
		final CandidateSet set = paper(drawn(LOOP), LOOP.first(), null);
		assertFalse(set.limited());
		final Set<String> walks = set.candidates().stream()
			.map(c -> c.steps().size() + (c.steps().get(1).forward() ? "+" : "-"))
			.collect(Collectors.toSet());
		assertEquals(3, set.candidates().size());
		assertTrue(walks.containsAll(Set.of("3+", "3-")));
		for (final Candidate c : set.candidates())
			assertEquals(LOOP.last(), c.path().last());
	}

	@Test
	void templateOwnWayComesFirstAndKeyVerticesLimitTheSearch() {
		final CandidateSet set = paper(drawn(LOOP), LOOP.first(), LOOP);
		assertEquals(3, set.candidates().get(0).steps().size());
		assertTrue(set.candidates().size() <= 3);
		final Polyline straight = Drawn.line(2, 60, 75, 60);
		assertEquals(2,
			paper(drawn(LOOP), LOOP.first(), straight).candidates().get(0).steps().size());
	}

	@Test
	void withoutEndPathsVisitAllVertices() {
		final Polyline closing = Drawn.line(2, 60, 40, 60, 55, 45, 40, 30, 25, 45, 40, 60);
		final CandidateSet set = paper(drawn(closing), closing.first(), null);
		assertEquals(2, set.candidates().size());
		for (final Candidate c : set.candidates())
			assertEquals(2, c.steps().size());
	}

	@Test
	void hittingTheLimitIsReported() {
		final Polyline loops = Drawn.line(5, 70, 40, 70, 50, 55, 35, 40, 25, 55, 35, 75, 90, 75,
			105, 55, 90, 35, 75, 55, 85, 80, 130, 85);
		final CandidateQuery query = CandidateQuery.of(drawn(loops), loops.first(),
			OptionalDouble.empty());
		assertTrue(new PaperCandidates(1, 3).generate(query, Progress.NONE).limited());
		assertFalse(new PaperCandidates(1000, 3).generate(query, Progress.NONE).limited());
		assertThrows(IllegalArgumentException.class, () -> new PaperCandidates(0, 3));
	}

	@Test
	void clampInsideASegmentAndEmptyGraph() {
		final Polyline over = Drawn.line(60, 50, 110, 50, 110, 20, 60, 20, 60, 90);
		assertFalse(paper(drawn(over), over.first(), over).candidates().isEmpty());
		assertTrue(paper(drawn(), new Point(3, 3), null).candidates().isEmpty());
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
	void simplePathsAreAllSimplePaths(final long seed) {
		final Random random = new Random(seed);
		final Polyline[] lines = new Polyline[4];
		for (int i = 0; i < lines.length; i++)
			lines[i] = Drawn.line(random.nextInt(140), random.nextInt(100), random.nextInt(140),
				random.nextInt(100));
		final SkeletonGraph g = drawn(lines);
		final FilamentDigraph d = FilamentDigraph.of(g, g.segments().get(0), Optional.empty());
		final Graph<Label, Contact> graph = d.asGraph();
		final PaperPaths.SimplePaths simple = new PaperPaths.SimplePaths(graph, 10_000);
		for (final Label to : d.labels()) {
			if (to.id() == d.start().id())
				continue;
			final Set<List<Contact>> expected = new AllDirectedPaths<>(graph)
				.getAllPaths(d.start(), to, true, null).stream().map(p -> p.getEdgeList())
				.collect(Collectors.toSet());
			assertEquals(expected, new HashSet<>(simple.between(d.start(), to)),
				"seed " + seed + " to " + to.id());
		}
	}
}
