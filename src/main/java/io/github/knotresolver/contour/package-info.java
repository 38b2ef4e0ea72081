/**
 * A candidate becomes a polyline, and polylines are compared.
 * <p>
 * {@link io.github.knotresolver.contour.ContourBuilder} smooths a walk over a
 * skeleton and samples it at one pixel;
 * {@link io.github.knotresolver.contour.GeodesicOrder} orders the pixels of an
 * unbranched skeleton.
 * {@link io.github.knotresolver.contour.DynamicTimeWarping},
 * {@link io.github.knotresolver.contour.DiscreteFrechet} and
 * {@link io.github.knotresolver.contour.EqualArcDistance} say how far two
 * contours are apart, each in its own sense.
 */

package io.github.knotresolver.contour;
