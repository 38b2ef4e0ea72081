package io.github.knotresolver.model;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.RealType;
import net.imglib2.view.Views;

/**
 * One channel of a time series: what everything starts from. It is read,
 * never written.
 *
 * @param name what the movie is called, usually the image's title
 * @param frames the pixels, three-dimensional: x, y, t; zero-min; any real type
 * @param calibration units of length and time
 */
public record Movie(String name, RandomAccessibleInterval<? extends RealType<?>> frames,
	Calibration calibration) {

	public Movie {
		if (frames.numDimensions() != 3)
			throw new IllegalArgumentException("A movie has three dimensions, x, y and t, but '"
				+ name + "' has " + frames.numDimensions() + ".");
	}

	/** @return the width in pixels */
	public int width() {
		return (int) frames.dimension(0);
	}

	/** @return the height in pixels */
	public int height() {
		return (int) frames.dimension(1);
	}

	/** @return the number of frames */
	public int size() {
		return (int) frames.dimension(2);
	}

	/**
	 * @param index 0-based index of the frame
	 * @return the frame's pixels: x, y
	 */
	public RandomAccessibleInterval<? extends RealType<?>> frame(final int index) {
		return Views.hyperSlice(frames, 2, frames.min(2) + index);
	}
}
