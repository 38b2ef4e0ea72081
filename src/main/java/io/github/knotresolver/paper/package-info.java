/**
 * The published method, whole, behind the same doors as ours: simple paths of a frame's graph
 * near the last contour ({@link io.github.knotresolver.paper.PaperCandidates}), of which the one
 * nearest by dynamic time warping is taken ({@link io.github.knotresolver.paper.PaperResolver}).
 * doi:10.1093/bioinformatics/btae538.
 */
package io.github.knotresolver.paper;
