
package io.github.knotresolver.mask;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.geometry.Point;

/** Follows one object through the masks of a movie. */
public final class ObjectFollower {

	private ObjectFollower() {
	}

	/**
	 * The published rule. In the first frame that has an object, it is the one
	 * under the point or nearest to it; in the others, the one that shares most
	 * pixels with the last mask that was found. Where nothing overlaps, the
	 * object is lost, and the search goes on from the last good mask. To follow
	 * from the middle of a movie, pass the frames from there on; to follow
	 * backwards, pass them in reverse. O(n) for all pixels of all frames.
	 *
	 * @param masks all objects of each frame, in the order to follow; all of the
	 *          same size
	 * @param point in pixels, on or near the object
	 * @return for each frame the object's mask; empty where it is lost
	 */
	public static List<Optional<Img<BitType>>> follow(
		final List<? extends RandomAccessibleInterval<BitType>> masks, final Point point) {
		final List<Optional<Img<BitType>>> found = new ArrayList<>(masks.size());
		Optional<Img<BitType>> last = Optional.empty();
		for (final RandomAccessibleInterval<BitType> mask : masks) {
			final ConnectedComponents components = ConnectedComponents.of(mask);
			final Optional<MaskObject> object = last.isEmpty()
				? components.nearest(point)
				: mostOverlapping(components, last.get());
			final Optional<Img<BitType>> now = object.map(components::mask);
			found.add(now);
			if (now.isPresent())
				last = now;
		}
		return found;
	}

	private static Optional<MaskObject> mostOverlapping(final ConnectedComponents components,
		final Img<BitType> last) {
		final int[] shared = components.overlap(last);
		Optional<MaskObject> best = Optional.empty();
		int most = 0;
		for (final MaskObject object : components.objects())
			if (shared[object.label()] > most) {
				most = shared[object.label()];
				best = Optional.of(object);
			}
		return best;
	}
}
