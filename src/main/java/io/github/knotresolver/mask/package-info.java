/**
 * A clean frame becomes the filament's mask. A threshold seeds a region-based
 * active contour; its mask is cleaned of specks and pin holes, and the object
 * that is the filament is followed from frame to frame.
 * <p>
 * Everything up to the masks of all objects of a frame looks at that frame
 * alone, so frames can be worked on in parallel; only
 * {@link io.github.knotresolver.mask.ObjectFollower} walks through the movie.
 * Masks are 8-connected, their holes 4-connected.
 */

package io.github.knotresolver.mask;
