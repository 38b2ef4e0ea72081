
package io.github.knotresolver.candidate;

import java.util.LinkedList;
import java.util.List;

import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.Step;

/** A walk that is being extended; shares its beginning with others. */
final class Trail {

	private final Trail before;
	private final Step step;
	private final Course course;
	private final double length;
	private final double covered;
	private final byte[] uses;
	private final double start;

	private Trail(final Trail before, final Step step, final Course course, final double start,
		final byte[] uses) {
		this.before = before;
		this.step = step;
		this.course = course;
		this.start = start;
		this.uses = uses;
		length = (before == null ? 0 : before.length) + step.length();
		covered = (before == null ? 0 : before.covered)
			+ (uses[step.segment().id()] == 0 ? step.length() : 0);
		uses[step.segment().id()]++;
	}

	/** A walk of one step, of a graph of so many segments. */
	static Trail along(final Step step, final int segments, final double start) {
		return new Trail(null, step, Course.along(step), start, new byte[segments]);
	}

	Trail then(final Step next) {
		return new Trail(this, next, course.then(next), start, uses.clone());
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

	double turning() {
		return course.turning();
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
