package io.github.knotresolver.imagej.plot;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;

import ij.ImagePlus;
import ij.gui.ImageCanvas;
import ij.process.FloatProcessor;
import io.github.knotresolver.measure.Kymograph;
import io.github.knotresolver.model.Calibration;

/**
 * A kymograph as a 32-bit image to measure on: arc length to the right, time
 * downwards, one row a frame, both calibrated; what is missing is NaN, shown
 * grey.
 */
final class KymographImage {

	private static final int LEAST_SIZE = 600, LARGEST_ZOOM = 32;

	private KymographImage() {
	}

	/** @return the image in colours from the lowest to the highest value */
	static ImagePlus rising(final String title, final Kymograph k, final Calibration c,
		final String valueUnit) {
		final DoubleSummaryStatistics range = range(k);
		return of(title, k, c, valueUnit, ColourMap.rising(range.getMin(), range.getMax()));
	}

	/** @return the image in colours on both sides of zero */
	static ImagePlus twoSided(final String title, final Kymograph k, final Calibration c,
		final String valueUnit) {
		final DoubleSummaryStatistics range = range(k);
		return of(title, k, c, valueUnit,
			ColourMap.twoSided(Math.max(-range.getMin(), range.getMax())));
	}

	private static DoubleSummaryStatistics range(final Kymograph k) {
		return Arrays.stream(k.values()).flatMapToDouble(Arrays::stream).filter(Double::isFinite)
			.summaryStatistics();
	}

	private static ImagePlus of(final String title, final Kymograph k, final Calibration c,
		final String valueUnit, final ColourMap colours) {
		final FloatProcessor pixels = new FloatProcessor(k.columns(), k.frames());
		for (int t = 0; t < k.frames(); t++)
			for (int j = 0; j < k.columns(); j++)
				pixels.setf(j, t, (float) k.values()[t][j]);
		colours.applyTo(pixels);
		final ImagePlus image = new ImagePlus(title, pixels);
		final ij.measure.Calibration calibration = new ij.measure.Calibration();
		calibration.pixelWidth = k.step();
		calibration.setXUnit(c.unit());
		calibration.pixelHeight = k.interval();
		calibration.setYUnit(c.timeUnit());
		calibration.setValueUnit(valueUnit);
		image.setCalibration(calibration);
		return image;
	}

	/** Shows it large enough to be seen: a kymograph has few pixels. */
	static void show(final ImagePlus kymograph) {
		kymograph.show();
		final ImageCanvas canvas = kymograph.getCanvas();
		while (canvas != null && canvas.getMagnification() < LARGEST_ZOOM
			&& canvas.getMagnification()
				* Math.max(kymograph.getWidth(), kymograph.getHeight()) < LEAST_SIZE)
			canvas.zoomIn(0, 0);
	}
}
