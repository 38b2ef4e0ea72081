package io.github.knotresolver.skeleton;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.RealType;

import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.image.Ridges;
import io.github.knotresolver.mask.RidgeMask;

/**
 * Finds the lines of a frame: ridges become a mask, the mask is thinned, and of the thin
 * lines what is not sure goes. Has no state that changes, so frames can be worked on in
 * parallel.
 */
public final class EvidenceFinder {

	private final LineAppearance appearance;

	/** @param appearance what the movie's lines look like */
	public EvidenceFinder(final LineAppearance appearance) {
		this.appearance = appearance;
	}

	/**
	 * Looks at a frame. Linear in the number of pixels.
	 *
	 * @param frame a frame of the movie, two-dimensional, any real type
	 * @return what can be seen of lines there
	 */
	public FrameEvidence find(final RandomAccessibleInterval<? extends RealType<?>> frame) {
		return find(Ridges.of(frame, appearance));
	}

	FrameEvidence find(final Ridges ridges) {
		final Img<BitType> mask = RidgeMask.of(ridges);
		final LinePixels line = lines(mask, ridges);
		double surest = 0;
		for (final int[] part : LineParts.of(line))
			surest = Math.max(surest, Surety.of(inside(line, part), ridges));
		return new FrameEvidence(ridges, around(line, mask), line.image(), surest);
	}

	/** @return the lines alone */
	LinePixels lines(final Ridges ridges) {
		return lines(RidgeMask.of(ridges), ridges);
	}

	private LinePixels lines(final Img<BitType> mask, final Ridges ridges) {
		final LinePixels line = new LinePixels(mask);
		final double s = appearance.workingSigma();
		LineParts.keep(line, part -> part.length >= SkeletonTuning.FIRST_LENGTH * s);
		final EndTrimmer ends = new EndTrimmer(ridges);
		ends.trim(line);
		Spurs.prune(line, (int) Math.ceil(SkeletonTuning.SPUR * s));
		Spurs.prune(line, (int) Math.ceil(SkeletonTuning.BEAD_BRANCH * s),
			branch -> isOfBeads(EvidenceFinder.inside(line, branch), ridges));
		ends.trim(line);
		final boolean[] edges = edges(ridges);
		final int longest = LineParts.of(line).stream().mapToInt(p -> p.length).max().orElse(0);
		LineParts.keep(line,
			part -> part.length >= SkeletonTuning.LENGTH_BEFORE_JOINING * s
				&& LineParts.count(part, at -> edges[at]) <= SkeletonTuning.EDGE_SHARE * part.length
				&& !(part.length < Math.min(SkeletonTuning.BEAD_CHAIN * s, longest)
					&& isOfBeads(part, ridges)));
		new GapJoiner(ridges).join(line);
		LineParts.keep(line, part -> part.length >= SkeletonTuning.LENGTH_IN_THE_END * s
			&& Surety.of(part, ridges) > SkeletonTuning.SURE_PART);
		return line;
	}

	private static boolean isOfBeads(final int[] pixels, final Ridges ridges) {
		return LineParts.count(pixels, ridges::isNearBlob) > SkeletonTuning.BEAD_SHARE
			* pixels.length;
	}

	static int[] inside(final LinePixels line, final int[] part) {
		final int[] inside = new int[part.length];
		for (int i = 0; i < part.length; i++)
			inside[i] = line.inside(part[i]);
		return inside;
	}

	/** Edges and their eight neighbours: a skeleton need not run on the crest. */
	private static boolean[] edges(final Ridges ridges) {
		final int width = ridges.width(), height = ridges.height();
		final boolean[] edges = new boolean[width * height];
		for (int at = 0; at < edges.length; at++)
			if (ridges.isEdge(at))
				mark(edges, width, at, 1);
		return edges;
	}

	/** The mask near the skeleton, and the skeleton. */
	private Img<BitType> around(final LinePixels line, final Img<BitType> mask) {
		final int width = line.width();
		final boolean[] near = new boolean[line.bits().length];
		final boolean[] core = line.bits(), wide = Pixels.bits(mask);
		for (int at = 0; at < core.length; at++)
			if (core[at])
				mark(near, width, at,
					(int) Math.ceil(SkeletonTuning.MASK_REACH * appearance.blurredSigma()));
		for (int at = 0; at < near.length; at++)
			near[at] = near[at] && wide[at] || core[at];
		return Pixels.mask(near, width);
	}

	private static void mark(final boolean[] bits, final int width, final int at,
		final int radius) {
		final int x = at % width, y = at / width, height = bits.length / width;
		for (int v = Math.max(0, y - radius); v <= Math.min(height - 1, y + radius); v++)
			for (int u = Math.max(0, x - radius); u <= Math.min(width - 1, x + radius); u++)
				bits[v * width + u] = true;
	}
}
