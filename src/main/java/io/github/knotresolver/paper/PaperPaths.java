package io.github.knotresolver.paper;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

import org.jgrapht.Graph;
import org.jgrapht.GraphPath;
import org.jgrapht.alg.shortestpath.YenKShortestPath;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.FilamentDigraph;
import io.github.knotresolver.graph.FilamentDigraph.Contact;
import io.github.knotresolver.graph.FilamentDigraph.Label;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.graph.Step;
import io.github.knotresolver.progress.Progress;

/** The published path generation for one start vertex. */
final class PaperPaths {

	private final Step first;
	private final FilamentDigraph digraph;
	private final SimplePaths simple;
	private final int perCombination;
	private boolean limited;

	PaperPaths(final SkeletonGraph graph, final Step first, final Optional<Segment> end,
		final int perCombination) {
		this.first = first;
		this.perCombination = perCombination;
		digraph = FilamentDigraph.of(graph, first.segment(), end);
		simple = new SimplePaths(digraph.asGraph(), perCombination);
	}

	/** The walks, the template's own first. */
	Set<List<Step>> walks(final Optional<Polyline> template, final int keyVertices,
		final Progress progress) {
		final Set<List<Contact>> paths = new LinkedHashSet<>();
		final Optional<TemplateTrace> trace = template.map(t -> new TemplateTrace(digraph, t));
		final List<Label> keys = trace.map(t -> t.keyLabels(keyVertices)).orElse(List.of());
		for (final Label last : digraph.end().map(List::of).orElse(digraph.labels())) {
			progress.checkCancelled();
			paths.addAll(legal(simple.between(digraph.start(), last)));
			for (final Label via : digraph.labels())
				paths.addAll(combined(via, last));
		}
		final Set<List<Step>> walks = new LinkedHashSet<>();
		trace.flatMap(TemplateTrace::roughPath).flatMap(this::steps).ifPresent(walks::add);
		kept(paths, keys).forEach(p -> walks.add(steps(p).orElseThrow()));
		return walks;
	}

	/** Whether a limit was hit. */
	boolean limited() {
		return limited || simple.limited();
	}

	private List<List<Contact>> legal(final List<List<Contact>> paths) {
		return paths.stream().filter(p -> steps(p).isPresent()).toList();
	}

	/** Paths from the start over a vertex to the last. */
	private List<List<Contact>> combined(final Label via, final Label last) {
		final List<List<Contact>> found = new ArrayList<>();
		if (via.id() == digraph.start().id() || via.id() == last.id())
			return found;
		for (final List<Contact> head : simple.between(digraph.start(), via))
			for (final List<Contact> tail : simple.between(via, last)) {
				final List<Contact> path = new ArrayList<>(head);
				path.addAll(tail);
				if (steps(path).isEmpty())
					continue;
				if (found.size() == perCombination) {
					limited = true;
					return found;
				}
				found.add(path);
			}
		return found;
	}

	private List<List<Contact>> kept(final Set<List<Contact>> paths, final List<Label> keys) {
		final List<List<Contact>> all = List.copyOf(paths);
		final List<List<Contact>> passing = all.stream().filter(p -> visited(p).containsAll(keys))
			.toList();
		final List<List<Contact>> chosen = passing.isEmpty() ? all : passing;
		if (digraph.end().isPresent())
			return chosen;
		final int most = chosen.stream().mapToInt(p -> visited(p).size()).max().orElse(0);
		return chosen.stream().filter(p -> visited(p).size() == most).toList();
	}

	/** A path of the digraph as a walk over segments; empty if it turns back inside a segment. */
	private Optional<List<Step>> steps(final List<Contact> path) {
		final List<Step> steps = new ArrayList<>(List.of(first));
		for (final Contact c : path) {
			final Step current = steps.get(steps.size() - 1);
			if (c.entersSegment()) {
				final Step next = new Step(c.to().filament().orElseThrow(), c.atSource());
				if (next.isReverseOf(current))
					return Optional.empty();
				steps.add(next);
			} else if (c.atSource() == current.forward())
				return Optional.empty();
		}
		return Optional.of(steps);
	}

	private Set<Label> visited(final List<Contact> path) {
		final Set<Label> visited = new LinkedHashSet<>(List.of(digraph.start()));
		path.forEach(c -> visited.add(c.to()));
		return visited;
	}

	/**
	 * Simple paths between vertices of the published digraph, those of fewest edges
	 * first and not more than a limit.
	 */
	static final class SimplePaths {

		private record Ends(int from, int to) {
		}

		private final Graph<Label, Contact> graph;
		private final int limit;
		private final Map<Ends, List<List<Contact>>> known = new HashMap<>();
		private boolean limited;

		SimplePaths(final Graph<Label, Contact> graph, final int limit) {
			this.graph = graph;
			this.limit = limit;
		}

		/** The edges of each path; one path without edges if both ends are the same. */
		List<List<Contact>> between(final Label from, final Label to) {
			return known.computeIfAbsent(new Ends(from.id(), to.id()), e -> search(from, to));
		}

		/** Whether there were more paths than the limit. */
		boolean limited() {
			return limited;
		}

		private List<List<Contact>> search(final Label from, final Label to) {
			if (from.id() == to.id())
				return List.of(List.of());
			final List<List<Contact>> paths = new ArrayList<>(new YenKShortestPath<>(graph)
				.getPaths(from, to, limit + 1).stream().map(GraphPath::getEdgeList).toList());
			if (paths.size() > limit) {
				limited = true;
				paths.remove(limit);
			}
			return paths;
		}
	}
}
