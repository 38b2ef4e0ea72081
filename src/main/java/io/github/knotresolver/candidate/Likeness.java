
package io.github.knotresolver.candidate;

import io.github.knotresolver.geometry.Polyline;

/**
 * Whether two walks are the same for all practical purposes: small holes and
 * spurs of a skeleton give many walks that differ by less than the filament is
 * wide.
 */
final class Likeness {

	/** Walks are compared at points this far apart (pixels of arc length). */
	private static final double STEP = 4;

	/** Alike walks stay this near (pixels) to each other. */
	private static final double NEAR = 4;

	private Likeness() {
	}

	static Polyline sample(final Candidate candidate) {
		return candidate.path().every(STEP);
	}

	static boolean alike(final Polyline a, final Polyline b) {
		final int n = Math.min(a.size(), b.size());
		if (Math.abs(a.size() - b.size()) * STEP > NEAR)
			return false;
		for (int i = n - 1; i >= 0; i--)
			if (Math.hypot(a.x(i) - b.x(i), a.y(i) - b.y(i)) > NEAR)
				return false;
		return true;
	}
}
