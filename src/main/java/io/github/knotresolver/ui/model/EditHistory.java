package io.github.knotresolver.ui.model;

import java.util.ArrayList;
import java.util.List;

/**
 * What was said, step by step, and where in it one stands. Immutable.
 *
 * @param states all states, the oldest first, at least one
 * @param at index of the present one
 */
record EditHistory(List<Edits> states, int at) {

	EditHistory {
		states = List.copyOf(states);
	}

	static EditHistory of(final Edits first) {
		return new EditHistory(List.of(first), 0);
	}

	Edits present() {
		return states.get(at);
	}

	/** @return with one more step; steps that were undone are forgotten */
	EditHistory with(final Edits next) {
		final List<Edits> more = new ArrayList<>(states.subList(0, at + 1));
		more.add(next);
		return new EditHistory(more, at + 1);
	}

	boolean canUndo() {
		return at > 0;
	}

	boolean canRedo() {
		return at + 1 < states.size();
	}

	/** @return one step back; the same at the oldest */
	EditHistory undone() {
		return new EditHistory(states, Math.max(0, at - 1));
	}

	/** @return one step forth; the same at the newest */
	EditHistory redone() {
		return new EditHistory(states, Math.min(states.size() - 1, at + 1));
	}
}
