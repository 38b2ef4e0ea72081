package io.github.knotresolver.fit;

/**
 * A frame in the units of the fit: background 0, a single bright strand 1.
 *
 * @param width in pixels
 * @param height in pixels
 * @param pixels row by row, {@code width * height} values; not to be changed
 */
public record NormalizedFrame(int width, int height, double[] pixels) {

	public NormalizedFrame {
		if (pixels.length != width * height)
			throw new IllegalArgumentException("A frame of " + width + " x " + height
				+ " pixels has " + pixels.length + " values.");
	}
}
