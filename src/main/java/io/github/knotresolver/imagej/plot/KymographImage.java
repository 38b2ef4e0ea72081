package io.github.knotresolver.imagej.plot;

import ij.ImagePlus;
import ij.process.FloatProcessor;
import io.github.knotresolver.geometry.Calibration;
import io.github.knotresolver.measure.Kymograph;

/**
 * A kymograph as a 32-bit image to measure on: arc length to the right, time
 * downwards, one row a frame, both calibrated; what is missing is NaN.
 */
public final class KymographImage {

	private KymographImage() {
	}

	/**
	 * @param title the image's title
	 * @param k the kymograph
	 * @param c units
	 * @param valueUnit unit of the values, such as {@code rad}
	 * @return the image
	 */
	public static ImagePlus of(final String title, final Kymograph k, final Calibration c,
		final String valueUnit) {
		final FloatProcessor pixels = new FloatProcessor(k.columns(), k.frames());
		for (int t = 0; t < k.frames(); t++)
			for (int j = 0; j < k.columns(); j++)
				pixels.setf(j, t, (float) k.values()[t][j]);
		pixels.resetMinAndMax();
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
}
