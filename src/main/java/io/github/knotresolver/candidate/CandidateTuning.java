package io.github.knotresolver.candidate;

/**
 * The numbers by which a graph becomes trails. Turns are 1 for a right angle and 2 for a
 * reversal. {@code scripts/ablation} measures what halving and doubling each does.
 */
final class CandidateTuning {

	/**
	 * [arms] A junction with more arms is not paired. Why: the search is exponential; seven
	 * strands in one place cannot be told apart anyway.
	 */
	static final int MOST_ARMS = 14;

	/**
	 * [turns] Price of an arm that stays alone. Why: two arms that leave at a right angle cost
	 * more together than apart: filaments do not bend so within a width.
	 */
	static final double ALONE = 0.9;

	/**
	 * [px] Ends that are nearer to each other have no direction between them. Why: that is the
	 * radius of a junction.
	 */
	static final double ONE_PLACE = 5;

	/**
	 * [turns] Price of pairing a short segment with itself. Why: above any other, so that it is
	 * the last resort.
	 */
	static final double OWN_END = 5;

	/**
	 * [px] ... if its ends are nearer than this. Why: a loop around a hole of the mask is that
	 * small; a filament's own loop is larger.
	 */
	static final double OWN_DISTANCE = 8;

	/**
	 * [px] Shorter segments have no direction of their own. Why: junctions bend three pixels at
	 * both ends, and the rest is too short to have a tangent.
	 */
	static final double NO_DIRECTION = 8;

	/**
	 * [px] Walks are compared at points this far apart. Why: a walk of a skeleton cannot leave and
	 * come back within less.
	 */
	static final double LIKENESS_STEP = 4;

	/**
	 * [px] Walks that stay this near to each other are one. Why: the holes and spurs of a skeleton
	 * make detours of half a line's width.
	 */
	static final double ALIKE = 4;

	/**
	 * [px] A segment between junctions that is no longer is part of a crossing. Why: two lines
	 * that cross at an angle of 30 degrees share that much of their skeleton.
	 */
	static final double BRIDGE = 7;

	/**
	 * [strands] A segment of this brightness holds two strands. Why: half way between one and two.
	 */
	static final double DOUBLE_STRAND = 1.5;

	/**
	 * [px] ... and is part of a crossing up to this length. Why: filaments that cross at a few
	 * degrees lie on each other that far; longer ones have their own trail.
	 */
	static final double DOUBLE_BRIDGE = 45;

	/**
	 * [trails] So many trails are looked at for each candidate that is wanted. Why: most trails
	 * differ from a cheaper one only by a spur or a hole.
	 */
	static final int RAW_PER_CANDIDATE = 10;

	/** [px] A trail is not cut this near to a node. Why: there it ends at the node. */
	static final double SHORTEST_CUT = 1;

	private CandidateTuning() {
	}
}
