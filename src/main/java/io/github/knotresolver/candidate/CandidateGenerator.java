
package io.github.knotresolver.candidate;

import io.github.knotresolver.progress.Progress;

/** Proposes possible contours of one frame. Implementations are stateless. */
public interface CandidateGenerator {

	/**
	 * Proposes contours.
	 *
	 * @param query what is known about the frame
	 * @param progress asked whether to stop
	 * @return possible contours; none if the graph has no segments
	 */
	CandidateSet generate(CandidateQuery query, Progress progress);
}
