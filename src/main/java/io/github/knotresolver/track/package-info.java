/**
 * The candidates of all frames become one contour a frame.
 * <p>
 * {@link io.github.knotresolver.track.FitResolver}, our default, fits the
 * candidates to the frames and takes the cheapest way through the fits of the whole
 * movie. Two methods on skeletons alone stand behind
 * {@link io.github.knotresolver.track.Resolver}:
 * {@link io.github.knotresolver.track.TrellisResolver}, and the published one, which
 * has a room of its own. {@link io.github.knotresolver.track.Trellis}
 * solves any such choice, whatever its vertices stand for.
 */
package io.github.knotresolver.track;
