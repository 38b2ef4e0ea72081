package io.github.knotresolver.evaluate.like;

import java.util.Arrays;
import java.util.List;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.RealType;

import org.apache.commons.math3.stat.descriptive.rank.Median;
import org.apache.commons.math3.util.ResizableDoubleArray;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.PixelNoise;
import io.github.knotresolver.image.Pixels;

/** One frame with its contour: background, and brightness over it near the contour. */
final class FrameSample {

	/** Takes a pixel near the contour. */
	@FunctionalInterface
	interface Neighbours {

		/**
		 * @param distance from the contour in pixels
		 * @param arc place along it, 0..1
		 * @param above brightness over the background
		 */
		void accept(double distance, double arc, double above);
	}

	/** Pixels this far apart on the contour are different ones. */
	private static final double STEP = 1.5;

	private final int width, height;
	private final double[] pixels;
	private final Polyline contour;
	private final NearField near;
	private final GreyRange range;
	private final double background, noise;

	/**
	 * @param frame the pixels
	 * @param contour the filament in it
	 * @param range the movie's grey values
	 * @param far pixels farther from the contour than this are background
	 */
	FrameSample(final RandomAccessibleInterval<? extends RealType<?>> frame, final Polyline contour,
		final GreyRange range, final double far) {
		width = Pixels.width(frame);
		height = Pixels.height(frame);
		pixels = Pixels.doubles(frame);
		this.contour = contour;
		this.range = range;
		near = new NearField(contour, width, height, far);
		final double[] beyond = pixels.clone();
		for (int i = 0; i < beyond.length; i++)
			if (isNear(i))
				beyond[i] = Double.NaN;
		final double[] values = Arrays.stream(beyond).filter(v -> !Double.isNaN(v)).toArray();
		background = values.length == 0 ? range.lowest() : new Median().evaluate(values);
		noise = PixelNoise.of(beyond, width);
	}

	private boolean isNear(final int pixel) {
		return near.distance(pixel) < Double.POSITIVE_INFINITY;
	}

	double background() {
		return background;
	}

	/** @return its standard deviation from pixel to pixel */
	double noise() {
		return noise;
	}

	/** @return where the contour crosses itself */
	List<Point> crossings() {
		return Crossings.of(contour.resampled(1));
	}

	/** @return brightness of the pixel at a place, over the background */
	double above(final Point p) {
		return pixels[pixel(p)] - background;
	}

	private int pixel(final Point p) {
		final int x = (int) Math.rint(Math.max(0, Math.min(width - 1, p.x())));
		return (int) Math.rint(Math.max(0, Math.min(height - 1, p.y()))) * width + x;
	}

	/** Gives every pixel beside the contour, not those around its ends. */
	void forEachBeside(final Neighbours visitor) {
		for (int i = 0; i < pixels.length; i++)
			if (isNear(i) && near.arc(i) > 0 && near.arc(i) < 1 && !Double.isNaN(pixels[i]))
				visitor.accept(Math.min(near.distance(i), AppearanceMeter.FAR - 1e-9), near.arc(i),
					pixels[i] - background);
	}

	/**
	 * Adds what pixels on the line differ by from the mean of the two before and
	 * after, in grey values of the line's middle, so that the spread is that of the noise.
	 */
	void addNoiseOnLine(final LineProfile profile, final ResizableDoubleArray differences) {
		final Polyline points = contour.resampled(STEP);
		final double[] value = new double[points.size()];
		for (int i = 0; i < value.length; i++) {
			final int pixel = pixel(points.point(i));
			value[i] = range.isCut(pixels[pixel])
				? Double.NaN
				: (pixels[pixel] - background) * profile.at(0) / profile.at(near.distance(pixel));
		}
		for (int i = 1; i < value.length - 1; i++) {
			final double d = value[i] - (value[i - 1] + value[i + 1]) / 2;
			if (!Double.isNaN(d))
				differences.addElement(d / Math.sqrt(1.5));
		}
	}
}
