/**
 * The candidates of all frames become one contour a frame.
 * <p>
 * Two methods stand behind {@link io.github.knotresolver.track.Resolver}:
 * {@link io.github.knotresolver.track.TrellisResolver}, our default, takes the
 * cheapest way through the candidates of the whole movie;
 * {@link io.github.knotresolver.track.GreedyResolver} is the published method,
 * which goes from frame to frame. {@link io.github.knotresolver.track.Trellis}
 * solves any such choice, whatever its vertices stand for.
 */
package io.github.knotresolver.track;
