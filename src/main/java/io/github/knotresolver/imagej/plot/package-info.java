/**
 * Figures of measurements, ready for print: JFreeChart charts as PNG and SVG,
 * kymographs as calibrated 32-bit images, ImageJ plots with live tables behind
 * them, animated overlays, and the folders of measurements and scores. All colours can be told apart with any colour
 * vision; frames without a contour are gaps.
 */
package io.github.knotresolver.imagej.plot;
