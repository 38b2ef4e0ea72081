package io.github.knotresolver.session;

import net.imglib2.RandomAccess;
import net.imglib2.RandomAccessibleInterval;
import net.imglib2.position.FunctionRandomAccessible;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;
import net.imglib2.view.Views;

import io.github.knotresolver.image.StuckPixels;

/** The frames of a movie with the camera's hot pixels filled in. */
final class FilledFrames {

	private FilledFrames() {
	}

	/** @return the frames, x, y and t; made anew whenever a pixel is asked for */
	static <T extends RealType<?>> RandomAccessibleInterval<FloatType> of(
		final RandomAccessibleInterval<T> frames, final StuckPixels hot) {
		final int width = (int) frames.dimension(0);
		final long left = frames.min(0), top = frames.min(1);
		return Views.interval(new FunctionRandomAccessible<>(3, () -> {
			final RandomAccess<T> pixels = frames.randomAccess();
			return (place, out) -> {
				pixels.setPosition(place);
				final int at = (int) ((place.getLongPosition(1) - top) * width
					+ place.getLongPosition(0) - left);
				out.set(hot.contains(at) ? (float) hot.filled(at, i -> {
					pixels.setPosition(left + i % width, 0);
					pixels.setPosition(top + i / width, 1);
					return pixels.get().getRealDouble();
				}) : pixels.get().getRealFloat());
			};
		}, FloatType::new), frames);
	}
}
