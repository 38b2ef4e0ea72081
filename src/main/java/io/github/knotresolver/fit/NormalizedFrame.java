package io.github.knotresolver.fit;

import java.lang.ref.WeakReference;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Supplier;

import io.github.knotresolver.image.GaussianBlur;
import io.github.knotresolver.image.PixelNoise;
import io.github.knotresolver.image.Pixels;

/**
 * A frame above its background, which is 0. The fit takes it {@link #rescaled} to a single
 * bright strand of 1; before that it is in the movie's grey values. Immutable.
 * <p>
 * One that was made of single precision keeps only that, or not even that, whatever its units:
 * {@link #pixels()} makes the values when they are asked for, and again if they were collected
 * in between. So a movie of such frames takes 4 bytes a pixel, or none.
 */
public final class NormalizedFrame {

	private static final double[] NONE = {};

	private final int width, height;
	private final Supplier<double[]> values;
	/** What they are made of. */
	private final Optional<Compact> compact;
	private final double[] ceiling;
	private final double widening;
	/** Of a pixel; NaN as long as nobody asked. */
	private volatile double noise = Double.NaN;

	/**
	 * A frame in focus, of which nothing was cut off.
	 *
	 * @param width in pixels
	 * @param height in pixels
	 * @param pixels row by row, {@code width * height} values; kept, not copied
	 */
	public NormalizedFrame(final int width, final int height, final double[] pixels) {
		this(width, height, () -> pixels, Optional.empty(), NONE, 1);
		requireSize(width, height, pixels.length);
	}

	private NormalizedFrame(final int width, final int height, final Supplier<double[]> values,
		final Optional<Compact> compact, final double[] ceiling, final double widening) {
		this.width = width;
		this.height = height;
		this.values = values;
		this.compact = compact;
		this.ceiling = ceiling;
		this.widening = widening;
	}

	/**
	 * @param width in pixels
	 * @param height in pixels
	 * @param pixels row by row, {@code width * height} values; kept, not copied
	 * @return the frame, in focus, of which nothing was cut off
	 */
	public static NormalizedFrame of(final int width, final int height, final float[] pixels) {
		requireSize(width, height, pixels.length);
		return of(width, height, new Kept(pixels));
	}

	/**
	 * A frame that is not kept.
	 *
	 * @param width in pixels
	 * @param height in pixels
	 * @param pixels makes {@code width * height} values row by row, always the same; asked
	 *          again and again, by any thread
	 * @return the frame, in focus, of which nothing was cut off
	 */
	public static NormalizedFrame of(final int width, final int height,
		final Supplier<float[]> pixels) {
		final Compact compact = new Compact(pixels, new double[0]);
		return new NormalizedFrame(width, height, compact, Optional.of(compact), NONE, 1);
	}

	private static void requireSize(final int width, final int height, final int pixels) {
		if (pixels != width * height)
			throw new IllegalArgumentException(
				"A frame of " + width + " x " + height + " pixels has " + pixels + " values.");
	}

	/**
	 * @param heights for every pixel the brightness above which it does not say how bright what
	 *          shone there was, since brighter ones were cut off; not to be changed
	 * @return the same frame of which it is known
	 */
	public NormalizedFrame withCeiling(final double[] heights) {
		if (heights.length != 0 && heights.length != width * height)
			throw new IllegalArgumentException("A frame of " + width * height
				+ " pixels has a ceiling of " + heights.length + ".");
		return new NormalizedFrame(width, height, values, compact, heights, widening);
	}

	/**
	 * @param times how many times as wide as usual lines are, above 0
	 * @return the same frame of which it is known
	 */
	public NormalizedFrame withWidening(final double times) {
		return new NormalizedFrame(width, height, values, compact, ceiling, times);
	}

	/** @return how many times as wide as usual lines are in it, above 0: it may be out of focus */
	public double widening() {
		return widening;
	}

	/** @return for every pixel where it is cut off; empty if none was */
	double[] ceiling() {
		return ceiling;
	}

	/** @return whether pixels were cut off anywhere in it */
	public boolean isClipped() {
		return ceiling.length > 0;
	}

	/** @return whether the pixel at a place in the frame was cut off */
	boolean isClipped(final double x, final double y) {
		final int at = (int) Math.rint(y) * width + (int) Math.rint(x);
		return isClipped() && part((int) Math.rint(x), (int) Math.rint(y), 1, 1)[0] >= ceiling[at];
	}

	/** @return whether a pixel does not say how bright what is drawn there is */
	boolean hides(final int at, final double drawn) {
		return ceiling.length > 0 && drawn > ceiling[at];
	}

	/** @return what the picture of lines that add up leaves of a pixel, one of {@link #pixels()} */
	double residual(final int at, final double pixel, final double drawn) {
		return hides(at, drawn) ? Math.min(0, pixel - ceiling[at]) : pixel - drawn;
	}

	/** @return what the picture of a line leaves; one that saturates is itself cut off */
	double residual(final int at, final double pixel, final double drawn, final LineModel model) {
		return model.kind() == LineModel.Kind.ADDITIVE ? residual(at, pixel, drawn) : pixel - drawn;
	}

	/** @return width in pixels */
	public int width() {
		return width;
	}

	/** @return height in pixels */
	public int height() {
		return height;
	}

	/** @return the values row by row, not to be changed; O(pixels), so ask once for all of a frame */
	public double[] pixels() {
		return values.get();
	}

	private record Kept(float[] get) implements Supplier<float[]> {
	}

	/** Values of single precision, and the backgrounds and amplitudes that they are brought to in turn. */
	private static final class Compact implements Supplier<double[]> {

		private final Supplier<float[]> source;
		private final double[] scales;
		private volatile WeakReference<double[]> made = new WeakReference<>(null);

		Compact(final Supplier<float[]> source, final double[] scales) {
			this.source = source;
			this.scales = scales;
		}

		Compact rescaled(final double background, final double amplitude) {
			final double[] more = Arrays.copyOf(scales, scales.length + 2);
			more[scales.length] = background;
			more[scales.length + 1] = amplitude;
			return new Compact(source, more);
		}

		@Override
		public double[] get() {
			final double[] known = made.get();
			if (known != null)
				return known;
			final float[] light = source.get();
			final double[] values = new double[light.length];
			for (int i = 0; i < values.length; i++)
				values[i] = light[i];
			scale(values);
			made = new WeakReference<>(values);
			return values;
		}

		/** The values of a part of a frame so many pixels wide, without all others. */
		double[] part(final int width, final Patch patch) {
			final double[] known = made.get();
			if (known != null)
				return patch.cut(known, width);
			final float[] light = source.get();
			final double[] values = new double[patch.width() * patch.height()];
			for (int row = 0, i = 0; row < patch.height(); row++)
				for (int c = 0; c < patch.width(); c++, i++)
					values[i] = light[(patch.top() + row) * width + patch.left() + c];
			scale(values);
			return values;
		}

		private void scale(final double[] values) {
			for (int k = 0; k < scales.length; k += 2)
				for (int i = 0; i < values.length; i++)
					values[i] = (values[i] - scales[k]) / scales[k + 1];
		}
	}

	/**
	 * @param background the value that becomes 0
	 * @param amplitude the height above it that becomes 1
	 * @return the frame in new units
	 */
	public NormalizedFrame rescaled(final double background, final double amplitude) {
		final double[] heights = scaled(ceiling, background, amplitude);
		if (compact.isPresent()) {
			final Compact scaled = compact.get().rescaled(background, amplitude);
			return new NormalizedFrame(width, height, scaled, Optional.of(scaled), heights,
				widening);
		}
		final double[] scaled = scaled(pixels(), background, amplitude);
		return new NormalizedFrame(width, height, () -> scaled, compact, heights, widening);
	}

	private static double[] scaled(final double[] values, final double background,
		final double amplitude) {
		final double[] scaled = new double[values.length];
		for (int i = 0; i < scaled.length; i++)
			scaled[i] = (values[i] - background) / amplitude;
		return scaled;
	}

	/**
	 * @param sigma of a Gaussian in pixels, above 0
	 * @return the frame blurred by it
	 */
	public NormalizedFrame blurred(final double sigma) {
		final NormalizedFrame blurred = isKept()
			? of(width, height, blur(sigma))
			: of(width, height, () -> blur(sigma));
		return blurred.withCeiling(ceiling).withWidening(widening);
	}

	/** Whether its values are in memory as long as it is. */
	private boolean isKept() {
		return compact.map(c -> c.source instanceof Kept).orElse(true);
	}

	private float[] blur(final double sigma) {
		return GaussianBlur.blur(Pixels.floats(pixels()), width, sigma);
	}

	/**
	 * A part of the frame.
	 *
	 * @param left first column
	 * @param top first row
	 * @param columns how many, at least 1
	 * @param rows how many, at least 1
	 * @return that part; it must lie inside the frame
	 */
	NormalizedFrame window(final int left, final int top, final int columns, final int rows) {
		final double[] part = part(left, top, columns, rows);
		return new NormalizedFrame(columns, rows, () -> part, Optional.empty(),
			isClipped() ? part(ceiling, left, top, columns, rows) : NONE, widening);
	}

	private double[] part(final int left, final int top, final int columns, final int rows) {
		return compact.isPresent()
			? compact.get().part(width, new Patch(left, top, columns, rows))
			: part(pixels(), left, top, columns, rows);
	}

	private double[] part(final double[] of, final int left, final int top, final int columns,
		final int rows) {
		final double[] part = new double[columns * rows];
		for (int r = 0; r < rows; r++)
			System.arraycopy(of, (top + r) * width + left, part, r * columns, columns);
		return part;
	}

	/** @return the {@link PixelNoise} of the frame; O(pixels) when it is asked for first */
	public double noise() {
		double known = noise;
		if (Double.isNaN(known)) {
			known = PixelNoise.of(pixels(), width);
			noise = known;
		}
		return known;
	}

	/**
	 * @param x column in pixels
	 * @param y row in pixels
	 * @return the mean of the 3 x 3 pixels around the nearest one, as far as they are in
	 *         the frame; NaN if none is
	 */
	public double meanAround(final double x, final double y) {
		final int column = (int) Math.rint(x), row = (int) Math.rint(y);
		final int left = Math.max(0, column - 1), right = Math.min(width - 1, column + 1);
		final int top = Math.max(0, row - 1), bottom = Math.min(height - 1, row + 1);
		if (left > right || top > bottom)
			return Double.NaN;
		double sum = 0;
		final double[] around = part(left, top, right - left + 1, bottom - top + 1);
		for (final double value : around)
			sum += value;
		return sum / around.length;
	}
}
