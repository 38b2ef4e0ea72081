/**
 * Contours become calibrated quantities: smoothed tangent angles and curvatures
 * along the filament, lengths, angles and energies per frame, and spectra and
 * travelling waves over time.
 * <p>
 * Everything is in the units of the movie's calibration. Angles are measured in
 * the image's own axes, x to the right and y DOWN: from the x axis towards the
 * y axis, which on the screen is clockwise. Positive curvature turns the same
 * way. Every quantity has a standard error that is propagated from the noise of
 * the contour's points, and a frame without a contour is missing, not zero.
 * Definitions, formulas and sources are also in {@code docs/measurements.md}.
 */

package io.github.knotresolver.measure;
