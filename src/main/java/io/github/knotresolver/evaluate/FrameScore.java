package io.github.knotresolver.evaluate;

/**
 * One frame of the truth and what the result made of it.
 *
 * @param frame 1-based
 * @param present whether the result has a contour there
 * @param crossings proper self-intersections of the true contour
 * @param score how near it is; {@link CurveScore#MISSING} without a contour
 */
public record FrameScore(int frame, boolean present, int crossings, CurveScore score) {
}
