package io.github.knotresolver.image;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.RealType;

import io.github.knotresolver.model.Polarity;

/**
 * Where a frame may have lines, in working pixels: brighter than both sides, by more than
 * the noise and by a part of what is usual in the movie.
 */
public final class Ridges {

	private final LineAppearance appearance;
	private final int width;
	private final float[] clean;
	private final RidgeStrength strength;
	private final float[] low;
	private final RidgeSides sides;
	private final Blobs blobs;

	private Ridges(final LineAppearance appearance, final float[] clean, final int width) {
		this.appearance = appearance;
		this.width = width;
		this.clean = clean;
		final Hessian hessian = Hessian.of(clean, width, appearance.filterSigma());
		strength = RidgeStrength.of(hessian, appearance.filterSigma());
		low = new float[clean.length];
		for (int at = 0; at < low.length; at++)
			low[at] = limit(at, ImageTuning.LOW, ImageTuning.LOW_SHARE);
		sides = new RidgeSides(hessian, strength, appearance.blurredSigma(), low);
		blobs = new Blobs(clean, hessian, appearance.filterSigma(), low, appearance.blurredSigma());
	}

	/**
	 * Looks at a frame. O(n sigma) for n pixels.
	 *
	 * @param frame a frame of the movie, two-dimensional
	 * @param appearance what the movie's lines look like
	 * @return the frame's ridges, in working pixels
	 */
	public static Ridges of(final RandomAccessibleInterval<? extends RealType<?>> frame,
		final LineAppearance appearance) {
		final int width = Pixels.width(frame);
		return of(HotPixels.clip(Pixels.floats(frame), width), width, appearance);
	}

	/**
	 * As {@link #of(RandomAccessibleInterval, LineAppearance)}.
	 *
	 * @param calm the frame without hot pixels, row by row
	 * @param width of a row in the movie's pixels
	 * @param appearance what the movie's lines look like
	 * @return the frame's ridges, in working pixels
	 */
	public static Ridges of(final float[] calm, final int width, final LineAppearance appearance) {
		final float[] clean = Binning.mean(calm, width, appearance.binning());
		if (appearance.polarity() == Polarity.DARK)
			for (int i = 0; i < clean.length; i++)
				clean[i] = -clean[i];
		return new Ridges(appearance, clean, width / appearance.binning());
	}

	/** @return what the lines look like */
	public LineAppearance appearance() {
		return appearance;
	}

	/** @return width of a row in working pixels */
	public int width() {
		return width;
	}

	/** @return number of rows in working pixels */
	public int height() {
		return clean.length / width;
	}

	/** @return the frame without hot pixels, lines bright, row by row; not to be changed */
	public float[] clean() {
		return clean;
	}

	/**
	 * @param at place of a pixel, row by row
	 * @return the negative second derivative across the line, per working px²
	 */
	public float strength(final int at) {
		return strength.strength(at);
	}

	/**
	 * @param at place of a pixel, row by row
	 * @return strength in units of its noise, see {@link RidgeStrength}
	 */
	public float z(final int at) {
		return strength.z(at);
	}

	/**
	 * @param at place of a pixel, row by row
	 * @return direction along the line in radians, 0 to below pi, from x towards y
	 */
	public double angle(final int at) {
		return strength.angle(at);
	}

	/**
	 * @param at place of a pixel, row by row
	 * @return how much brighter it is than one line width to its sides; 0 where there is
	 *         no line
	 */
	public float drop(final int at) {
		return sides.drop(at);
	}

	/**
	 * @param at place of a pixel, row by row
	 * @return whether it is the border of something bright rather than a line
	 */
	public boolean isEdge(final int at) {
		return sides.isEdge(at);
	}

	/**
	 * @param at place of a pixel, row by row
	 * @return whether it is near the middle of a round spot: a bead, or where strands cross
	 */
	public boolean isNearBlob(final int at) {
		return blobs.isNear(at);
	}

	/**
	 * @param at place of a pixel, row by row
	 * @return whether a line is beyond doubt there
	 */
	public boolean isSure(final int at) {
		return sides.isCrest(at)
			&& strength.strength(at) > limit(at, ImageTuning.HIGH, ImageTuning.HIGH_SHARE);
	}

	/**
	 * The full width at half maximum of the line, from its drop and its curvature: those
	 * of a Gaussian line of variance T² are related by (1 - exp(-u)) / u with u = t²/2T².
	 *
	 * @param at place of a pixel, row by row
	 * @return the width in the movie's pixels
	 */
	public double lineWidth(final int at) {
		final double t = appearance.blurredSigma(), f = appearance.filterSigma();
		final double ratio = sides.drop(at) / (strength.strength(at) * t * t / 2);
		final double variance = t * t / (2 * exponent(ratio)) - f * f;
		return LineAppearance.FULL_WIDTH * appearance.binning()
			* Math.sqrt(Math.max(ImageTuning.LEAST_VARIANCE, variance));
	}

	/** @return u with (1 - exp(-u)) / u = ratio, 0.002..20 */
	private static double exponent(final double ratio) {
		double low = 0.002, high = 20;
		for (int i = 0; i < 30; i++) {
			final double u = (low + high) / 2;
			if ((1 - Math.exp(-u)) / u > ratio)
				low = u;
			else
				high = u;
		}
		return (low + high) / 2;
	}

	/**
	 * The pixels that may belong to lines: above the noise, and not much weaker than the
	 * strongest within a line width, so that strands that lie close do not melt.
	 *
	 * @return a mask, row by row
	 */
	public boolean[] candidates() {
		final float[] above = new float[clean.length];
		for (int at = 0; at < above.length; at++)
			if (strength.strength(at) > low[at])
				above[at] = strength.strength(at);
		final float[] strongest = LocalMaximum.of(above, width,
			(int) Math.round(appearance.blurredSigma()));
		final boolean[] mask = new boolean[above.length];
		for (int at = 0; at < mask.length; at++)
			mask[at] = above[at] > 0 && above[at] > relative(at) * strongest[at];
		return mask;
	}

	private double relative(final int at) {
		return appearance.hasReference() && sides.isCrest(at)
			? ImageTuning.RELATIVE_ON_CREST
			: ImageTuning.RELATIVE;
	}

	private float limit(final int at, final double noises, final double share) {
		final double limit = noises * strength.noise(at);
		return (float) (appearance.hasReference()
			? Math.max(limit, share * appearance.reference())
			: limit);
	}
}
