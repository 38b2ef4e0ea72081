package io.github.knotresolver.mask;

/**
 * One connected object of a mask.
 *
 * @param label its number, from 1 in the order in which a row-by-row scan meets
 *          the objects
 * @param pixels how many pixels it has
 * @param minX leftmost column, 0-based
 * @param minY topmost row, 0-based
 * @param maxX rightmost column
 * @param maxY bottommost row
 * @param touchesBorder whether it reaches the border of the frame
 */
public record MaskObject(int label, int pixels, int minX, int minY, int maxX, int maxY,
	boolean touchesBorder) {
}
