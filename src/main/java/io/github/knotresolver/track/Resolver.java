package io.github.knotresolver.track;

import io.github.knotresolver.progress.Progress;

/** Chooses one contour for each frame, on skeletons alone. Implementations are stateless. */
public interface Resolver {

	/**
	 * Resolves a movie. A frame without a graph comes back {@code LOST}, one that
	 * cannot be decided {@code UNRESOLVED}, one that the user gave {@code CORRECTED}; a
	 * limit of the search that was hit is told in the frame's reason.
	 *
	 * @param query the frames and what is known
	 * @param progress told how far the work is, and asked whether to stop
	 * @return one contour a frame
	 */
	Track resolve(ResolverQuery query, Progress progress);
}
