
package io.github.knotresolver.candidate;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;

import io.github.knotresolver.candidate.ArmPairing.Arm;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.graph.Step;

/**
 * All filaments of a frame, as its graph shows them: every segment belongs to one trail, and
 * at every junction the arms are paired ({@link ArmPairing}). Two junctions that a short
 * segment joins, or one in which two strands lie on each other, are one crossing.
 */
public final class SceneTrails {

	private final SkeletonGraph graph;
	private final int[] group;
	private final List<Segment> segments = new ArrayList<>();
	private final Map<Step, Step> next = new HashMap<>();
	private int loose;

	/**
	 * What was found.
	 *
	 * @param curves one for each trail, in pixels
	 * @param loose number of ends that lie at junctions
	 * @param crossings number of pairs at junctions
	 */
	public record Found(List<Polyline> curves, int loose, int crossings) {
	}

	private SceneTrails(final SkeletonGraph graph) {
		this.graph = graph;
		group = new int[graph.nodes().size()];
		for (int i = 0; i < group.length; i++)
			group[i] = i;
	}

	/**
	 * O(segments), and exponential in the number of arms of a junction, which is bounded.
	 *
	 * @param graph of a frame
	 * @param brightness of a curve, in strands
	 * @return its trails
	 */
	public static Found of(final SkeletonGraph graph, final ToDoubleFunction<Polyline> brightness) {
		final SceneTrails trails = new SceneTrails(graph);
		trails.joinCrossings(brightness);
		trails.pairArms();
		final List<Polyline> curves = trails.walk();
		return new Found(curves, trails.loose, trails.next.size() / 2);
	}

	private void joinCrossings(final ToDoubleFunction<Polyline> brightness) {
		final List<Segment> kept = new ArrayList<>();
		for (final Segment s : graph.segments()) {
			final boolean between = s.source().isJunction() && s.target().isJunction();
			if (between && !s.isLoop()
				&& (s.length() <= CandidateTuning.BRIDGE
					|| s.length() <= CandidateTuning.DOUBLE_BRIDGE
						&& brightness.applyAsDouble(s.curve()) > CandidateTuning.DOUBLE_STRAND))
				group[find(s.source().id())] = find(s.target().id());
			else
				kept.add(s);
		}
		for (final Segment s : kept)
			if (!(s.length() <= CandidateTuning.BRIDGE && s.source().isJunction()
				&& s.target().isJunction() && find(s.source().id()) == find(s.target().id())))
				segments.add(s);
	}

	private int find(final int node) {
		int root = node;
		while (group[root] != root)
			root = group[root];
		return root;
	}

	private void pairArms() {
		final Map<Integer, List<Step>> arms = new TreeMap<>();
		for (final Segment s : segments)
			for (final Step out : List.of(new Step(s, true), new Step(s, false)))
				if (out.from().isJunction())
					arms.computeIfAbsent(find(out.from().id()), g -> new ArrayList<>()).add(out);
		for (final List<Step> steps : arms.values()) {
			final int[] partner = ArmPairing.pair(steps.stream().map(SceneTrails::arm).toList());
			for (int i = 0; i < partner.length; i++)
				if (partner[i] < 0)
					loose++;
				else
					next.put(reversed(steps.get(i)), steps.get(partner[i]));
		}
	}

	private static Arm arm(final Step out) {
		final Point away = out.departure();
		return new Arm(out.from().position(), new Point(-away.x(), -away.y()), out.segment().id());
	}

	private static Step reversed(final Step step) {
		return new Step(step.segment(), !step.forward());
	}

	/** Walks all trails: those that have an end first, then those that are closed. */
	private List<Polyline> walk() {
		final Set<Segment> used = new HashSet<>();
		final List<Polyline> curves = new ArrayList<>();
		for (final boolean closed : new boolean[]{false, true})
			for (final Segment s : segments)
				for (final Step start : List.of(new Step(s, true), new Step(s, false)))
					if (!used.contains(s) && (closed || !next.containsKey(reversed(start))))
						curves.add(walk(start, used));
		return curves.stream().filter(c -> c.size() > 1 && c.length() > 1).toList();
	}

	private Polyline walk(final Step start, final Set<Segment> used) {
		final List<Point> points = new ArrayList<>();
		for (Step at = start; at != null && used.add(at.segment()); at = next.get(at)) {
			final Polyline curve = at.curve();
			for (int i = 0; i < curve.size(); i++)
				points.add(curve.point(i));
		}
		return Polyline.of(points);
	}
}
