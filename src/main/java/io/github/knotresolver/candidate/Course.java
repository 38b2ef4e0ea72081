package io.github.knotresolver.candidate;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Step;

/**
 * How much a walk has turned at junctions. Segments too short to have a
 * direction of their own (the bridge between the two halves of a crossing) are
 * looked across: the turn is taken between what comes before and after.
 *
 * @param heading direction of the last segment that has one, at its end
 * @param pending whether a junction was passed since
 * @param turning sum of 1 - cos of the turns
 */
record Course(Point heading, boolean pending, double turning) {

	static Course along(final Step first) {
		return new Course(first.arrival(), false, 0);
	}

	Course then(final Step next) {
		final boolean passed = pending || next.from().isJunction();
		if (next.length() < CandidateTuning.NO_DIRECTION)
			return new Course(heading, passed, turning);
		final Point d = next.departure();
		final double turn = passed ? 1 - (heading.x() * d.x() + heading.y() * d.y()) : 0;
		return new Course(next.arrival(), false, turning + Math.max(0, turn));
	}
}
