/**
 * The ImageJ edge: images become movies, results become ROIs, tables, overlays
 * and pictures. Only this room and those below it know {@code ij.*} and AWT.
 * <p>
 * The half pixel between this program's coordinates (an integer is a pixel
 * centre) and ImageJ's is added in one place,
 * {@link io.github.knotresolver.imagej.RoiConverter}.
 */

package io.github.knotresolver.imagej;
