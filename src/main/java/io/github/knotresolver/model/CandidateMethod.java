package io.github.knotresolver.model;

/** Which candidate contours are generated from a frame's graph. */
public enum CandidateMethod {
	/** The published method: simple paths near the template. */
	PAPER,
	/** Trails that may use a segment twice. */
	TRAILS
}
