
package io.github.knotresolver.mask;

import java.util.OptionalDouble;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.progress.Cancellation;

/** Moves the outline of a mask to where the frame turns dark. */
public final class ChanVese {

	private ChanVese() {
	}

	/**
	 * Region-based active contour without edges, as a level set in a narrow band
	 * around the front. With the mean intensities c1 inside and c2 outside the
	 * mask, the front moves outwards with the speed
	 *
	 * <pre>
	 * (2 I - c1 - c2) / (c1 - c2) - contractionBias - smoothFactor * curvature
	 * </pre>
	 *
	 * where curvature, in 1/px, is positive where the mask is convex. Without
	 * smoothing the front comes to rest at the intensity that lies at (1 +
	 * contractionBias) / 2 of the way from outside to inside: half way for 0, 70
	 * % for 0.4. The first term is held within -1..1, and is 0 if it is no
	 * brighter inside than outside: a mask that has lost its object shrinks by its
	 * bias. One iteration moves the front by at most half a pixel. A mask that
	 * vanishes stays empty, and a mask that fills the frame has no front and stays
	 * as it is. Pixels without a value (NaN) count as the lowest of the frame.
	 * O(iterations * length of the front).
	 * <p>
	 * Chan and Vese 2001, doi:10.1109/83.902291; the band is Whitaker's sparse
	 * field, 1998, doi:10.1023/A:1008036829907.
	 *
	 * @implNote op names="knotresolver.chanVese"
	 * @param frame a clean frame
	 * @param seed the mask to start from, of the same size
	 * @param iterations how often the front is moved, at least 0
	 * @param contractionBias -1..1; positive shrinks the mask
	 * @param smoothFactor at least 0; the larger, the smoother the outline
	 * @return a new mask of the same size
	 */
	public static Img<BitType> evolve(final RandomAccessibleInterval<FloatType> frame,
		final RandomAccessibleInterval<BitType> seed, final int iterations,
		final double contractionBias, final double smoothFactor) {
		Masks.requireSameSize(frame, seed);
		new Segmentation(Segmentation.Steps.BOTH, Polarity.AUTO, OptionalDouble.empty(), iterations,
			contractionBias, smoothFactor);
		final float[] values = Pixels.floats(frame);
		final SparseField field = new SparseField(Pixels.bits(seed), Pixels.width(frame));
		RegionMeans means = RegionMeans.of(values, field);
		for (int i = 0; i < iterations; i++) {
			Cancellation.check();
			field.move(steps(field, values, means, contractionBias, smoothFactor));
			means = RegionMeans.of(values, field);
		}
		return Pixels.mask(field.inside(), Pixels.width(frame));
	}

	/** @return by how many pixels each point of the front moves outwards */
	private static float[] steps(final SparseField field, final float[] values,
		final RegionMeans means, final double contractionBias, final double smoothFactor) {
		final float[] steps = new float[field.frontSize()];
		for (int i = 0; i < steps.length; i++) {
			final int at = field.front(i);
			final double data = means.likeness(values[at]);
			final double speed = data - contractionBias - smoothFactor * field.curvature(at);
			steps[i] = (float) within(MaskTuning.LONGEST_STEP, MaskTuning.TIME_STEP * speed);
		}
		return steps;
	}

	private static double within(final double limit, final double value) {
		return Math.max(-limit, Math.min(limit, value));
	}

	/**
	 * Mean intensities of the two regions of a frame.
	 *
	 * @param inside mean inside the mask
	 * @param outside mean outside the mask
	 */
	private record RegionMeans(double inside, double outside) {

		static RegionMeans of(final float[] values, final SparseField field) {
			double all = 0;
			double inside = 0;
			int count = 0;
			for (int at = 0; at < values.length; at++) {
				all += values[at];
				if (!field.contains(at))
					continue;
				inside += values[at];
				count++;
			}
			return new RegionMeans(inside / count, (all - inside) / (values.length - count));
		}

		/**
		 * How much a value is like the inside: 1 at the mean inside, -1 at the mean
		 * outside, within -1..1; 0 if the inside is no brighter or a region is empty.
		 */
		double likeness(final double value) {
			if (!(inside > outside))
				return 0;
			return Math.max(-1, Math.min(1, (2 * value - inside - outside) / (inside - outside)));
		}
	}
}
