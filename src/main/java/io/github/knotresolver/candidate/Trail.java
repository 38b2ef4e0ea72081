
package io.github.knotresolver.candidate;

import java.util.LinkedList;
import java.util.List;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.Step;

/** A walk that is being extended; shares its beginning with others. */
final class Trail {

	private final Trail before;
	private final Step step;
	/** Direction of the last segment that has one, at its end. */
	private final Point heading;
	/** Whether a junction was passed since. */
	private final boolean pending;
	private final double turning;
	private final double length;
	private final double covered;
	private final byte[] uses;
	private final double start;

	/** A walk of one step. */
	private Trail(final Step first, final double start, final byte[] uses) {
		before = null;
		step = first;
		heading = first.arrival();
		pending = false;
		turning = 0;
		this.start = start;
		this.uses = uses;
		length = first.length();
		covered = first.length();
		uses[first.segment().id()]++;
	}

	/**
	 * A walk with one step more. Segments too short to have a direction of their own (the bridge
	 * between the two halves of a crossing) are looked across: the turn is taken between what comes
	 * before and after.
	 */
	private Trail(final Trail before, final Step step) {
		this.before = before;
		this.step = step;
		start = before.start;
		uses = before.uses.clone();
		final boolean passed = before.pending || step.from().isJunction();
		final boolean bridge = step.length() < CandidateTuning.NO_DIRECTION;
		heading = bridge ? before.heading : step.arrival();
		pending = bridge && passed;
		turning = before.turning + (bridge || !passed ? 0 : turn(before.heading, step.departure()));
		length = before.length + step.length();
		covered = before.covered + (uses[step.segment().id()] == 0 ? step.length() : 0);
		uses[step.segment().id()]++;
	}

	private static double turn(final Point from, final Point to) {
		return Math.max(0, 1 - (from.x() * to.x() + from.y() * to.y()));
	}

	/** A walk of one step, of a graph of so many segments. */
	static Trail along(final Step step, final int segments, final double start) {
		return new Trail(step, start, new byte[segments]);
	}

	Trail then(final Step next) {
		return new Trail(this, next);
	}

	/**
	 * Whether a step may follow: no reversal, no segment more often than allowed.
	 */
	boolean allows(final Step next, final int maxUses) {
		return uses[next.segment().id()] < maxUses && !next.isReverseOf(step);
	}

	Node at() {
		return step.to();
	}

	double length() {
		return length;
	}

	double lengthBefore() {
		return length - step.length();
	}

	double lastLength() {
		return step.length();
	}

	/** Skeleton that is covered if the walk ends within its last step. */
	double covered(final double end) {
		final boolean first = uses[step.segment().id()] == 1;
		return first ? covered - step.length() + end : covered;
	}

	/** Sum of 1 - cos of the turns at junctions. */
	double turning() {
		return turning;
	}

	double start() {
		return start;
	}

	List<Step> steps() {
		final LinkedList<Step> steps = new LinkedList<>();
		for (Trail t = this; t != null; t = t.before)
			steps.addFirst(t.step);
		return steps;
	}
}
