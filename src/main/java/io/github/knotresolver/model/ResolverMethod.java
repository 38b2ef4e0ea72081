package io.github.knotresolver.model;

/** How one contour per frame is chosen among the candidates. */
public enum ResolverMethod {
	/** The published method: nearest to the last contour by DTW. */
	PAPER,
	/** The cheapest way through the whole movie. */
	MOVIE
}
