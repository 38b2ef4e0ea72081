package io.github.knotresolver.paper;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.graph.Contact;
import io.github.knotresolver.graph.Label;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.Step;

/** Turns paths of the published digraph into walks over segments. */
final class LabelWalk {

	private LabelWalk() {
	}

	/**
	 * The steps of a path that begins in the start vertex.
	 *
	 * @param first the step in the start vertex
	 * @param contacts the path's edges
	 * @return the steps; empty if the path turns back inside a segment
	 */
	static Optional<List<Step>> steps(final Step first, final List<Contact> contacts) {
		final List<Step> steps = new ArrayList<>(List.of(first));
		for (final Contact c : contacts) {
			final Step current = steps.get(steps.size() - 1);
			if (c.entersSegment()) {
				final Step next = new Step(segment(c.to()), c.atSource());
				if (next.isReverseOf(current))
					return Optional.empty();
				steps.add(next);
			} else if (c.atSource() == current.forward())
				return Optional.empty();
		}
		return Optional.of(steps);
	}

	private static Segment segment(final Label label) {
		return label.filament().orElseThrow();
	}
}
