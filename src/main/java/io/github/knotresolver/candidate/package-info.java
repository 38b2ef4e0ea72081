/**
 * A graph becomes possible contours with their price.
 * <p>
 * A {@link io.github.knotresolver.candidate.Candidate} is a walk over the
 * segments of a skeleton graph that begins at the fixed end. Two generators
 * stand behind {@link io.github.knotresolver.candidate.CandidateGenerator}:
 * {@link io.github.knotresolver.candidate.TrailCandidates}, our default, may
 * use every segment twice and needs no template; that of the published method
 * has a room of its own. Their limits are parameters, and a
 * {@link io.github.knotresolver.candidate.CandidateSet} says whether one was
 * hit.
 */

package io.github.knotresolver.candidate;
