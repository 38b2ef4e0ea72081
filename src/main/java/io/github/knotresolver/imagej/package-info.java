/**
 * The ImageJ edge: images become movies, results become ROIs, tables, overlays
 * and pictures. Only this room and those below it know {@code ij.*} and AWT.
 * <p>
 * Coordinates are the same on both sides of that edge: in ImageJ's line and point
 * selections, too, an integer is the centre of a pixel; see
 * {@link io.github.knotresolver.imagej.RoiConverter}.
 */

package io.github.knotresolver.imagej;
