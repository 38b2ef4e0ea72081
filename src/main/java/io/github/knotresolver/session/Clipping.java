package io.github.knotresolver.session;

import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

import net.imglib2.RandomAccess;
import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.RealType;
import net.imglib2.view.Views;

import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.ConnectedComponents;
import io.github.knotresolver.mask.ConnectedComponents.MaskObject;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.track.FrameView;

/**
 * Whether the brightest pixels of a movie were cut off, by the camera or by a
 * contrast stretch. Where a single strand already reaches the ceiling, strands that
 * cross cannot be brighter.
 *
 * @param ceiling the largest value of the pixels looked at; of dark lines, the smallest's
 *          negative
 * @param share the share of the pixels looked at that pile up at their largest value
 * @param most the share up to which the movie is not clipped
 */
record Clipping(double ceiling, double share, double most) {

	/** Looks at all pixels of some frames. */
	static Clipping of(final Movie movie, final List<Integer> frames) {
		return of(frames.stream().map(frame -> Pixels.doubles(movie.frame(frame - 1))).toList(),
			SessionTuning.CLIPPED_PIXELS);
	}

	/**
	 * Looks along the longest line of each frame only: what lies elsewhere (a saturated bead,
	 * a flash) says nothing about strands.
	 *
	 * @param frames with evidence
	 * @param pixels what their pixels are
	 */
	static Clipping along(final Movie movie, final List<FrameView> frames,
		final WorkingPixels pixels) {
		return of(frames.stream().map(frame -> crests(movie, frame, pixels)).toList(),
			SessionTuning.CLIPPED_LENGTH);
	}

	/** How bright (of dark lines, how dark) the line is at each pixel of the skeleton. */
	private static double[] crests(final Movie movie, final FrameView frame,
		final WorkingPixels pixels) {
		final FrameEvidence evidence = frame.evidence().orElseThrow();
		final int sign = evidence.appearance().polarity().sign();
		final RandomAccessibleInterval<? extends RealType<?>> image = movie
			.frame(frame.frame() - 1);
		final ConnectedComponents parts = ConnectedComponents.of(evidence.skeleton());
		final Optional<MaskObject> longest = parts.objects().stream()
			.max(Comparator.comparingInt(MaskObject::pixels));
		return IntStream.range(0, evidence.size())
			.filter(i -> parts.at(evidence.x(i), evidence.y(i)).equals(longest))
			.mapToDouble(i -> crest(image, pixels.out(new Point(evidence.x(i), evidence.y(i))),
				pixels.binning(), sign))
			.toArray();
	}

	/**
	 * The largest value beside a pixel of the skeleton; where that stands for a block of pixels, their
	 * median: noise takes some of them to the ceiling, and no strand.
	 */
	private static <T extends RealType<?>> double crest(final RandomAccessibleInterval<T> image,
		final Point at, final int block, final int sign) {
		final RandomAccess<T> access = Views.extendBorder(image).randomAccess();
		final long x = Math.round(at.x()), y = Math.round(at.y());
		final int radius = Math.max(1, block / 2);
		final DoubleStream.Builder values = DoubleStream.builder();
		for (long v = y - radius; v <= y + radius; v++)
			for (long u = x - radius; u <= x + radius; u++)
				values.add(sign
					* access.setPositionAndGet(image.min(0) + u, image.min(1) + v).getRealDouble());
		// Pixels may be without a value.
		final double[] sorted = values.build().filter(Double::isFinite).sorted().toArray();
		if (sorted.length == 0)
			return Double.NEGATIVE_INFINITY;
		return sorted[block == 1 ? sorted.length - 1 : sorted.length / 2];
	}

	private static Clipping of(final List<double[]> values, final double most) {
		double largest = Double.NEGATIVE_INFINITY, smallest = Double.POSITIVE_INFINITY;
		for (final double[] frame : values)
			for (final double value : frame) {
				// Comparisons are false for pixels without a value.
				largest = value > largest ? value : largest;
				smallest = value < smallest ? value : smallest;
			}
		final double below = largest - SessionTuning.BELOW_CEILING * (largest - smallest);
		long at = 0, justBelow = 0, pixels = 0;
		for (final double[] frame : values)
			for (final double value : frame) {
				pixels++;
				if (value == largest)
					at++;
				else if (value >= below)
					justBelow++;
			}
		return new Clipping(largest, at > justBelow ? (double) at / pixels : 0, most);
	}

	boolean isClipped() {
		return share > most;
	}

	/** How strands may add up in such a movie. */
	Set<LineModel.Kind> kinds() {
		return isClipped() ? EnumSet.of(LineModel.Kind.SATURATING) : LineModel.UNCLIPPED;
	}
}
