package io.github.knotresolver.paper;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.Candidate.Price;
import io.github.knotresolver.candidate.CandidateGenerator;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.RootedGraph;
import io.github.knotresolver.graph.Step;
import io.github.knotresolver.progress.Progress;

/**
 * The published method: paths of the digraph of branch and filament vertices from
 * the start over each vertex to the end, at most so many per combination. The
 * template's own rough sequence of vertices is the first candidate, and the key
 * vertices, those nearest to the template, limit the search: paths that miss one
 * are dropped, unless all do. Where no end can be seen, a path ends at the last
 * vertex visited, and those that visit the most vertices are kept. Prices are all
 * 0: the template decides.
 *
 * @param perCombination most paths per combination of vertices, at least 1
 * @param keyVertices number of key vertices, at least 0
 */
public record PaperCandidates(int perCombination, int keyVertices) implements CandidateGenerator {

	/** The published limits. */
	public static final PaperCandidates DEFAULT = new PaperCandidates(10, 3);

	public PaperCandidates {
		if (perCombination < 1 || keyVertices < 0)
			throw new IllegalArgumentException(
				"perCombination must be at least 1 and keyVertices at least 0, but are "
					+ perCombination + " and " + keyVertices + ".");
	}

	@Override
	public CandidateSet generate(final CandidateQuery query, final Progress progress) {
		final RootedGraph rooted = RootedGraph.of(query.graph(), query.fixedEnd());
		if (rooted.roots().isEmpty())
			return new CandidateSet(List.of(), false);
		final Node root = rooted.roots().get(0);
		final Optional<Step> end = end(rooted, root, query);
		final Set<List<Step>> walks = new LinkedHashSet<>();
		boolean limited = false;
		for (final Step first : rooted.graph().stepsFrom(root)) {
			final PaperPaths paths = new PaperPaths(rooted.graph(), first, end.map(Step::segment),
				perCombination);
			walks.addAll(paths.walks(query.template(), keyVertices, progress));
			limited |= paths.limited();
		}
		return new CandidateSet(walks.stream().map(w -> Candidate.whole(w, Price.NONE)).toList(),
			limited);
	}

	/** The step from the free end that is nearest to where the tip was. */
	private static Optional<Step> end(final RootedGraph rooted, final Node root,
		final CandidateQuery query) {
		final List<Node> others = new ArrayList<>(rooted.graph().freeEnds());
		others.removeIf(n -> n.id() == root.id());
		final Comparator<Node> farthest = Comparator
			.comparingDouble(n -> -n.position().distanceTo(query.fixedEnd()));
		final Optional<Point> tip = query.template().map(t -> t.last());
		final Comparator<Node> preferred = tip
			.map(t -> Comparator.comparingDouble((Node n) -> n.position().distanceTo(t)))
			.orElse(farthest);
		return others.stream().min(preferred).map(n -> rooted.graph().stepsFrom(n).get(0));
	}
}
