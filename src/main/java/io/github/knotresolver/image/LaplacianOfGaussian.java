
package io.github.knotresolver.image;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.model.Cleaning;

/** Brings out bright lines on an uneven background. */
public final class LaplacianOfGaussian {

	private LaplacianOfGaussian() {
	}

	/**
	 * The negative Laplacian of the Gaussian-smoothed frame: high on bright
	 * ridges about as wide as the Gaussian, whatever the background's brightness
	 * or slope. What is negative (dark ridges, the sides of bright ones) becomes
	 * 0, the highest response becomes 1; a constant frame becomes all 0. Beyond
	 * the border the outermost pixels are repeated; pixels without a value (NaN)
	 * count as the lowest of the frame. The kernel is separated: O(n size) for n
	 * pixels.
	 * <p>
	 * Marr and Hildreth 1980, doi:10.1098/rspb.1980.0020.
	 *
	 * @implNote op names="knotresolver.laplacianOfGaussian"
	 * @param frame a two-dimensional image
	 * @param size edge of the kernel in pixels, odd, 3..99
	 * @param sigma standard deviation of the Gaussian in pixels, above 0, at most
	 *          50
	 * @return a new image of the same size, 0..1
	 */
	public static Img<FloatType> enhance(final RandomAccessibleInterval<FloatType> frame,
		final int size, final double sigma) {
		final Cleaning checked = new Cleaning(size, sigma);
		if (!checked.enhances())
			return Pixels.image(Pixels.floats(frame), Pixels.width(frame));
		final int width = Pixels.width(frame);
		final float[] in = Pixels.floats(frame);
		final double[] gauss = SeparableFilter.gauss(size, sigma);
		final double[] ridge = ridge(gauss, sigma);
		final float[] across = SeparableFilter.alongRows(
			SeparableFilter.transposed(SeparableFilter.alongRows(in, width, gauss), width),
			in.length / width, ridge);
		final float[] along = SeparableFilter.alongRows(
			SeparableFilter.transposed(SeparableFilter.alongRows(in, width, ridge), width),
			in.length / width, gauss);
		final float[] sum = new float[in.length];
		for (int i = 0; i < sum.length; i++)
			sum[i] = across[i] + along[i];
		return Pixels.image(SeparableFilter.transposed(positivePart(sum), in.length / width),
			width);
	}

	/** The negative second derivative, its mean taken out: flat stays flat. */
	private static double[] ridge(final double[] gauss, final double sigma) {
		final double variance = sigma * sigma;
		final double[] kernel = new double[gauss.length];
		double mean = 0;
		for (int i = 0; i < kernel.length; i++) {
			final double x = i - kernel.length / 2;
			kernel[i] = gauss[i] * (variance - x * x) / (variance * variance);
			mean += kernel[i] / kernel.length;
		}
		for (int i = 0; i < kernel.length; i++)
			kernel[i] -= mean;
		return kernel;
	}

	/** Rounding noise of a flat frame is not a ridge. */
	private static float[] positivePart(final float[] response) {
		float highest = 0;
		for (final float value : response)
			highest = Math.max(highest, value);
		final float scale = highest > 1e-6f ? 1 / highest : 0;
		for (int i = 0; i < response.length; i++)
			response[i] = Math.min(1, Math.max(0, response[i]) * scale);
		return response;
	}
}
