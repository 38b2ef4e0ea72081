/**
 * A frame becomes the mask of its lines. By our default those ridges stay that are beyond doubt
 * somewhere ({@link io.github.knotresolver.mask.RidgeMask}). By the way of thresholds a threshold
 * seeds a region-based active contour; its mask is cleaned of specks and pin holes. Where one
 * filament is meant, the object that it is in is followed from frame to frame.
 * <p>
 * Everything up to the masks of all objects of a frame looks at that frame
 * alone, so frames can be worked on in parallel; only
 * {@link io.github.knotresolver.mask.ObjectFollower} walks through the movie.
 * Masks are 8-connected, their holes 4-connected.
 */

package io.github.knotresolver.mask;
