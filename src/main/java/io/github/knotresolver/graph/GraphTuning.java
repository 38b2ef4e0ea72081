package io.github.knotresolver.graph;

/**
 * The numbers by which a skeleton becomes a graph. They are pixels because a skeleton is: one
 * pixel wide, whatever the line was. {@code scripts/ablation} measures what halving and
 * doubling each does.
 */
public final class GraphTuning {

	/**
	 * [px] A loop of a junction that is shorter is a notch. Why: three branch pixels in a triangle
	 * are a loop of that length.
	 */
	static final double NOTCH = 5;

	/**
	 * [px] A spur whose tip is this near to a point to keep is kept. Why: as long as the longest
	 * spur that is pruned.
	 */
	static final double KEPT = 4;

	/**
	 * [px] What is this near to a clamp is at it: a free end of a skeleton, an object, an end that
	 * was learned. Why: thinning takes half a width off an end, and people point to it within a
	 * few pixels.
	 */
	public static final double NEAR_CLAMP = 12;

	/**
	 * [px] A free end this much farther away than the nearest segment still wins. Why: a filament
	 * begins at an end; a strand that passes the clamp is nearer by up to its width.
	 */
	static final double END_PREFERENCE = 5;

	/**
	 * [px] A node this near is not split off once more. Why: the mean place of a junction's pixels
	 * is that uncertain.
	 */
	static final double SAME_NODE = 2;

	/**
	 * [px] Thinning takes no more than this off an end. Why: half the width of the widest usual
	 * mask.
	 */
	static final double MOST_HIDDEN = 5;

	/**
	 * [px] The pixels' staircase is smoothed with this standard deviation. Why: a stair is one to
	 * three pixels long.
	 */
	static final double STAIRCASE = 1.5;

	/**
	 * [px] A junction bends the skeleton this near to it. Why: where two strands cross, both
	 * skeletons run through one place for about the radius of the line.
	 */
	static final double JUNCTION_BEND = 3;

	/**
	 * [px] Tangents are taken over this much of the curve. Why: half a pixel of rounding turns a
	 * tangent over 9 px by 3 degrees; over more, the filament's own bend shows.
	 */
	static final double TANGENT = 9;

	private GraphTuning() {
	}
}
