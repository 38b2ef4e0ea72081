package io.github.knotresolver.candidate;

import java.util.List;

/**
 * The possible contours of one frame.
 *
 * @param candidates the generator's best first; may be empty
 * @param limited whether a limit of the search was hit, so that a better
 *          candidate may have been missed
 */
public record CandidateSet(List<Candidate> candidates, boolean limited) {

	public CandidateSet {
		candidates = List.copyOf(candidates);
	}

	/** @return a sentence that says so if a limit was hit; empty if none was */
	public String limitReason() {
		return limited
			? "The search hit a limit: a better contour may have been missed; if it is wrong, draw the frame as a correction."
			: "";
	}
}
