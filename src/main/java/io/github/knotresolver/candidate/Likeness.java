
package io.github.knotresolver.candidate;

import io.github.knotresolver.geometry.Polyline;

/**
 * Whether two walks are the same for all practical purposes: small holes and
 * spurs of a skeleton give many walks that differ by less than the filament is
 * wide.
 */
final class Likeness {

	private Likeness() {
	}

	static Polyline sample(final Candidate candidate) {
		return candidate.path().every(CandidateTuning.LIKENESS_STEP);
	}

	static boolean alike(final Polyline a, final Polyline b) {
		final int n = Math.min(a.size(), b.size());
		if (Math.abs(a.size() - b.size()) * CandidateTuning.LIKENESS_STEP > CandidateTuning.ALIKE)
			return false;
		for (int i = n - 1; i >= 0; i--)
			if (Math.hypot(a.x(i) - b.x(i), a.y(i) - b.y(i)) > CandidateTuning.ALIKE)
				return false;
		return true;
	}
}
