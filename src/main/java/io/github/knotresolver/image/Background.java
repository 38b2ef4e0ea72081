package io.github.knotresolver.image;

import java.util.Arrays;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.geometry.RobustStatistics;

/** What a frame would be without its lines. */
public final class Background {

	/** Gaussians over cells: the fine one where it has enough pixels, else the next. */
	private static final double[] SIGMAS = {2, 5, 12, 40};

	private Background() {
	}

	/**
	 * The local mean of the pixels outside a mask, by Gaussians of 8 px and, where those
	 * see too few pixels, wider ones; pixels that stick out are left out. What the whole frame
	 * does, a slope or a bow, is told first. Slopes, haze and vignettes are followed, lines are
	 * bridged. O(n) for n pixels.
	 * <p>
	 * Normalized convolution: Knutsson and Westin 1993, doi:10.1109/CVPR.1993.341081.
	 *
	 * @implNote op names="knotresolver.background"
	 * @param frame a two-dimensional image; pixels without a value (NaN) do not count
	 * @param lines a mask of the same size: what is not background
	 * @return a new image of the same size
	 */
	public static Img<FloatType> of(final RandomAccessibleInterval<? extends RealType<?>> frame,
		final RandomAccessibleInterval<BitType> lines) {
		final double[] values = Pixels.doubles(frame);
		final float[] pixels = new float[values.length];
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = (float) values[i];
		return Pixels.image(of(pixels, Pixels.width(frame), Pixels.bits(lines)),
			Pixels.width(frame));
	}

	/**
	 * As {@link #of(RandomAccessibleInterval, RandomAccessibleInterval)}.
	 *
	 * @param pixels row by row
	 * @param width of a row
	 * @param lines what is not background, row by row
	 * @return the background, row by row
	 */
	public static float[] of(final float[] pixels, final int width, final boolean[] lines) {
		final boolean[] out = lines.clone();
		for (int i = 0; i < out.length; i++)
			out[i] |= !Float.isFinite(pixels[i]);
		float[] background = alongTrend(pixels, width, out);
		for (int round = 0; round < ImageTuning.BACKGROUND_ROUNDS; round++) {
			final double limit = ImageTuning.OUTLIER * spread(pixels, background, out);
			for (int i = 0; i < out.length; i++)
				out[i] |= Math.abs(pixels[i] - background[i]) > limit;
			background = alongTrend(pixels, width, out);
		}
		return background;
	}

	/** The trend of the whole frame, and the local mean of what is left. */
	private static float[] alongTrend(final float[] pixels, final int width, final boolean[] out) {
		final BackgroundTrend trend = BackgroundTrend.of(pixels, width, out);
		if (!trend.isThere())
			return smooth(pixels, width, out);
		final float[] values = trend.values(), rest = new float[pixels.length];
		for (int i = 0; i < rest.length; i++)
			rest[i] = pixels[i] - values[i];
		final float[] background = smooth(rest, width, out);
		for (int i = 0; i < rest.length; i++)
			background[i] += values[i];
		return background;
	}

	private static double spread(final float[] pixels, final float[] background,
		final boolean[] out) {
		final float[] off = new float[pixels.length];
		int count = 0;
		for (int i = 0; i < off.length; i++)
			if (!out[i])
				off[count++] = Math.abs(pixels[i] - background[i]);
		if (count == 0)
			return 0;
		Arrays.sort(off, 0, count);
		// All alike: nothing sticks out.
		return off[count / 2] > 0
			? RobustStatistics.MAD_TO_SD * off[count / 2]
			: Double.POSITIVE_INFINITY;
	}

	private static float[] smooth(final float[] pixels, final int width, final boolean[] out) {
		final int height = pixels.length / width;
		final int columns = (width + ImageTuning.CELL - 1) / ImageTuning.CELL,
			rows = (height + ImageTuning.CELL - 1) / ImageTuning.CELL;
		final float[] sums = new float[columns * rows], counts = new float[columns * rows];
		double sum = 0, count = 0;
		for (int i = 0; i < pixels.length; i++)
			if (!out[i]) {
				final int cell = i / width / ImageTuning.CELL * columns
					+ i % width / ImageTuning.CELL;
				sums[cell] += pixels[i];
				counts[cell]++;
				sum += pixels[i];
				count++;
			}
		return spreadOut(cells(sums, counts, columns, count == 0 ? 0 : (float) (sum / count)),
			columns, width, height);
	}

	private static float[] cells(final float[] sums, final float[] counts, final int columns,
		final float mean) {
		final float[] cells = new float[sums.length];
		final boolean[] done = new boolean[sums.length];
		Arrays.fill(cells, mean);
		for (final double sigma : SIGMAS) {
			final float[] s = blur(sums, columns, sigma), n = blur(counts, columns, sigma);
			boolean all = true;
			for (int i = 0; i < cells.length; i++)
				if (!done[i] && n[i] > ImageTuning.ENOUGH * ImageTuning.CELL * ImageTuning.CELL) {
					cells[i] = s[i] / n[i];
					done[i] = true;
				} else
					all &= done[i];
			if (all)
				break;
		}
		return cells;
	}

	private static float[] blur(final float[] cells, final int columns, final double sigma) {
		final double[] gauss = SeparableFilter.gauss(2 * (int) Math.ceil(3 * sigma) + 1, sigma);
		return SeparableFilter.rows(SeparableFilter.columns(cells, columns, gauss), columns, gauss);
	}

	/** From the cells' centres to pixels, linearly. */
	private static float[] spreadOut(final float[] cells, final int columns, final int width,
		final int height) {
		final float[] out = new float[width * height];
		for (int y = 0; y < height; y++)
			for (int x = 0; x < width; x++)
				out[y * width + x] = (float) Pixels.between(cells, columns,
					(x - (ImageTuning.CELL - 1) / 2.0) / ImageTuning.CELL,
					(y - (ImageTuning.CELL - 1) / 2.0) / ImageTuning.CELL);
		return out;
	}
}
