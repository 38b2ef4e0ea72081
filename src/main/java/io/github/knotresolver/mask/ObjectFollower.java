
package io.github.knotresolver.mask;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.mask.ConnectedComponents.MaskObject;

/** Follows one object through the masks of a movie. */
public final class ObjectFollower {

	private ObjectFollower() {
	}

	/**
	 * The published rule. In the first frame that has an object, it is the one
	 * under the point or nearest to it; in the others, the one that shares most
	 * pixels with the last mask that was found. Where nothing overlaps, the object
	 * is lost, and the search goes on from the last good mask. To follow from the
	 * middle of a movie, pass the frames from there on; to follow backwards, pass
	 * them in reverse. O(n) for all pixels of all frames.
	 *
	 * @param masks all objects of each frame, in the order to follow; all of the
	 *          same size
	 * @param point in pixels, on or near the object
	 * @return for each frame the object's mask; empty where it is lost
	 */
	public static List<Optional<Img<BitType>>> follow(
		final List<? extends RandomAccessibleInterval<BitType>> masks, final Point point) {
		return follow(masks, point, Optional.empty());
	}

	/**
	 * As {@link #follow}, but knows that the object is clamped: of the objects that
	 * overlap with the last mask, one within reach of the clamp goes before one
	 * that is not, however large. So a foreign filament that touched the object for
	 * a while does not take its place when they part.
	 *
	 * @param masks all objects of each frame, in the order to follow; all of the
	 *          same size
	 * @param clamp the fixed end, in pixels
	 * @param reach how far from the clamp the object may begin, in pixels, at
	 *          least 0
	 * @return for each frame the object's mask; empty where it is lost
	 */
	public static List<Optional<Img<BitType>>> followClamped(
		final List<? extends RandomAccessibleInterval<BitType>> masks, final Point clamp,
		final double reach) {
		if (!(reach >= 0))
			throw new IllegalArgumentException(
				"The reach of the clamp must be 0 pixels or more, but is " + reach + ".");
		return follow(masks, clamp, Optional.of(reach));
	}

	private static List<Optional<Img<BitType>>> follow(
		final List<? extends RandomAccessibleInterval<BitType>> masks, final Point point,
		final Optional<Double> reach) {
		final List<Optional<Img<BitType>>> found = new ArrayList<>(masks.size());
		Optional<Img<BitType>> last = Optional.empty();
		for (final RandomAccessibleInterval<BitType> mask : masks) {
			final ConnectedComponents components = ConnectedComponents.of(mask);
			final Optional<MaskObject> object;
			if (last.isEmpty())
				object = components.nearest(point);
			else {
				final int[] shared = components.overlap(last.get());
				object = reach.flatMap(r -> most(components.near(point, r), shared))
					.or(() -> most(components.objects(), shared));
			}
			final Optional<Img<BitType>> now = object.map(components::mask);
			found.add(now);
			if (now.isPresent())
				last = now;
		}
		return found;
	}

	/** @return the object that shares most pixels, the first of several */
	private static Optional<MaskObject> most(final List<MaskObject> objects, final int[] shared) {
		MaskObject best = null;
		for (final MaskObject object : objects)
			if (shared[object.label()] > (best == null ? 0 : shared[best.label()]))
				best = object;
		return Optional.ofNullable(best);
	}
}
