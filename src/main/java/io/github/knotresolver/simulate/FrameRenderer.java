
package io.github.knotresolver.simulate;

import io.github.knotresolver.geometry.Polyline;

/** Draws one frame of a movie with known truth. */
public interface FrameRenderer {

	/**
	 * Draws one frame. The same frame is drawn the same, whatever was drawn
	 * before.
	 *
	 * @param curve the filament in pixels
	 * @param frame 0-based index of the frame
	 * @param canvas the view
	 * @param depth range of grey values
	 * @return grey values row by row, {@code width * height} of them, with noise,
	 *         neither rounded nor clipped
	 */
	double[] render(Polyline curve, int frame, Canvas canvas, BitDepth depth);
}
