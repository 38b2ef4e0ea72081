package io.github.knotresolver.paper;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import org.jgrapht.Graph;
import org.jgrapht.GraphPath;
import org.jgrapht.alg.shortestpath.YenKShortestPath;

import io.github.knotresolver.graph.FilamentDigraph.Contact;
import io.github.knotresolver.graph.FilamentDigraph.Label;

/**
 * Simple paths between vertices of the published digraph, those of fewest edges
 * first and not more than a limit.
 */
final class SimplePaths {

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
