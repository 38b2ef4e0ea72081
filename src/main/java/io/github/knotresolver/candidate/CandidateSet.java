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
}
