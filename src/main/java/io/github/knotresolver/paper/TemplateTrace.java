package io.github.knotresolver.paper;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import org.jgrapht.GraphPath;
import org.jgrapht.alg.shortestpath.BFSShortestPath;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.FilamentDigraph;
import io.github.knotresolver.graph.FilamentDigraph.Contact;
import io.github.knotresolver.graph.FilamentDigraph.Label;

/** What the last contour says about the vertices of the published digraph. */
final class TemplateTrace {

	private final FilamentDigraph digraph;
	private final Polyline template;

	TemplateTrace(final FilamentDigraph digraph, final Polyline template) {
		this.digraph = digraph;
		this.template = template;
	}

	/** The vertices that lie nearest to the template, by the mean over their points. */
	List<Label> keyLabels(final int count) {
		return digraph.labels().stream().sorted(Comparator.comparingDouble(this::distance))
			.limit(count).toList();
	}

	private double distance(final Label label) {
		return label.points().stream()
			.mapToDouble(p -> IntStream.range(0, template.size())
				.mapToDouble(i -> template.point(i).distanceTo(p)).min().orElseThrow())
			.average().orElseThrow();
	}

	/**
	 * The vertices that the template passes, in its order, gaps closed by shortest
	 * paths.
	 *
	 * @return the edges of that path; empty if the graph does not allow it
	 */
	Optional<List<Contact>> roughPath() {
		final List<Contact> path = new ArrayList<>();
		Label at = digraph.start();
		for (final Label next : passed()) {
			if (next.id() == at.id())
				continue;
			final GraphPath<Label, Contact> gap = new BFSShortestPath<>(digraph.asGraph())
				.getPath(at, next);
			if (gap == null)
				return Optional.empty();
			path.addAll(gap.getEdgeList());
			at = next;
		}
		return Optional.of(path);
	}

	private List<Label> passed() {
		final List<Label> passed = new ArrayList<>();
		for (int i = 0; i < template.size(); i++) {
			final Label near = nearest(template.point(i));
			if (passed.isEmpty() || passed.get(passed.size() - 1).id() != near.id())
				passed.add(near);
		}
		return passed;
	}

	private Label nearest(final Point p) {
		return digraph.labels().stream()
			.min(Comparator.comparingDouble(
				l -> l.points().stream().mapToDouble(p::distanceTo).min().orElseThrow()))
			.orElseThrow();
	}
}
