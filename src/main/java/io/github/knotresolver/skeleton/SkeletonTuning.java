package io.github.knotresolver.skeleton;

/**
 * The numbers by which evidence becomes lines. A line width is the standard deviation of the
 * line's profile, a noise sigma the standard deviation of the ridge strength where there is no
 * line. {@code scripts/ablation} measures what halving and doubling each does.
 */
final class SkeletonTuning {

	/**
	 * [px] Frames that are looked at to learn the line's look have so many pixels together. Why:
	 * medians over a megapixel are sure enough, and a large movie must not wait.
	 */
	static final double LOOKED_AT = 1e6;

	/**
	 * [frames] ... but there are at least so many. Why: one frame may be out of focus or empty; a
	 * median of four passes over it.
	 */
	static final int FEWEST_LOOKS = 4;

	/**
	 * [frames] ... and at most so many. Why: small frames are alike, and eight have a median
	 * already.
	 */
	static final int MOST_LOOKS = 8;

	/**
	 * [px] Margin around what was found that is looked at again. Why: it is the edge of the tiles
	 * in which noise is measured.
	 */
	static final int LOOK_MARGIN = 48;

	/**
	 * [rounds] How often the width is measured, each time with the filter of the width before.
	 * Why: the first filter may be a factor of two off, the second one is nearly right.
	 */
	static final int WIDTH_ROUNDS = 2;

	/**
	 * [times] The width grows by this factor at most in a round. Why: a filter that is wider by
	 * half still sees the line; from there the next round goes on.
	 */
	static final double MOST_WIDENING = 1.5;

	/**
	 * [times] ... and shrinks to this part at most. Why: the vote starts from widths that are a
	 * factor of two apart.
	 */
	static final double MOST_NARROWING = 0.5;

	/**
	 * [line widths] The shortest part that is kept at first. Why: crests of filtered noise are
	 * about as long as its filter, several widths.
	 */
	static final double FIRST_LENGTH = 7;

	/**
	 * [line widths] ... once ends and spurs are cut, before gaps are closed. Why: cut ends have
	 * taken up to two widths off a part that was just long enough.
	 */
	static final double LENGTH_BEFORE_JOINING = 5;

	/**
	 * [line widths] ... and in the end. Why: as at first: what is no longer than a crest of noise
	 * has no direction to tell it by.
	 */
	static final double LENGTH_IN_THE_END = 7;

	/**
	 * [line widths] Side branches that are shorter are spurs. Why: thinning leaves spurs of up to
	 * half the mask's width.
	 */
	static final double SPUR = 3;

	/**
	 * [share] A part of which more than this is an edge is no line. Why: a line beside a bright
	 * object is an edge here and there, a border nearly all along.
	 */
	static final double EDGE_SHARE = 0.6;

	/**
	 * [line widths] Side branches of beads are no longer than this. Why: the light of a bead as
	 * wide as two lines draws ridges that far.
	 */
	static final double BEAD_BRANCH = 12;

	/**
	 * [line widths] ... chains of beads no longer than this, and not the longest part of the
	 * frame. Why: two or three beads in a row; a filament with beads on it is longer.
	 */
	static final double BEAD_CHAIN = 24;

	/**
	 * [share] ... and more than this part of them is near the middles of round spots. Why:
	 * crossings look like spots, too, but cover less of a filament.
	 */
	static final double BEAD_SHARE = 0.7;

	/**
	 * [noise sigma] Every part must stand out by this as a whole. Why: a frame has thousands of
	 * places, of which noise makes one reach four now and then.
	 */
	static final double SURE_PART = 5;

	/**
	 * [line widths] The mask reaches this far to both sides of the skeleton. Why: there a Gaussian
	 * line has fallen to about a quarter of its height.
	 */
	static final double MASK_REACH = 1.6;

	/**
	 * [share] A free end lies where the contrast is this part of that before it. Why: the half
	 * height of a blurred step is where the step is.
	 */
	static final double END_SHARE = 0.5;

	/**
	 * [share] "That before it" is this quantile of the contrast. Why: the upper quartile passes
	 * over a gap or a crossing in the stretch.
	 */
	static final double END_QUANTILE = 0.75;

	/**
	 * [line widths] ... over a stretch of this length. Why: blur reaches two widths, so the
	 * stretch holds some of the line beyond.
	 */
	static final double END_STRETCH = 3;

	/**
	 * [stretches] How far an end may be moved. Why: noise and blur draw a line on by up to so
	 * much, and a faint strand must not be eaten up.
	 */
	static final double END_FARTHEST = 3;

	/** [noise sigma] A tail below this is faint. Why: single crests of noise reach nearly that. */
	static final double FAINT_TAIL = 5;

	/**
	 * [share] ... or, in movies with little contrast, below this part of what is usual. Why: half
	 * is further from the usual strength than a filament's own unevenness.
	 */
	static final double FAINT_SHARE = 0.5;

	/**
	 * [noise sigma] A faint tail must stand out by this as a whole. Why: there are few tails in a
	 * frame, so less is asked than of a part.
	 */
	static final double SURE_TAIL = 3;

	/**
	 * [line widths] The widest gap that is closed. Why: where strands cross at a sharp angle the
	 * ridge is lost for that long.
	 */
	static final double GAP_REACH = 8;

	/** [px] Ends that are closer touch. Why: the diagonal of a pixel. */
	static final double TOUCHING = 1.5;

	/**
	 * [cosine] How far an end may look past the other. Why: 37 degrees, which leaves room for a
	 * bend within the gap and for the error of an end's direction.
	 */
	static final double FACING = 0.8;

	/**
	 * [px] An end's direction is that of so many pixels. Why: fewer and the staircase of the
	 * pixels shows, more and the filament bends.
	 */
	static final int GAP_DIRECTION = 7;

	/**
	 * [noise sigma] The light in a gap must stand out by this as a whole. Why: both ends speak for
	 * it already.
	 */
	static final double SURE_GAP = 1.5;

	/**
	 * [noise sigma] The mean ridge strength along a crest of noise. Why: it is the largest of
	 * eight directions, taken on a crest.
	 */
	static final double MEAN_OF_NOISE = 1.5;

	/**
	 * [filter sigma] Places that are this far apart see other noise. Why: the filter averages over
	 * about that length along the line.
	 */
	static final double INDEPENDENT = 3;

	/**
	 * [ratio] Focus wanders if lines are so much wider in some of the frames that are looked at than
	 * in others. Why: noise and beads change them by a fifth.
	 */
	static final double WANDERS = 1.3;

	/** [frames] Of so many the widest and the narrowest do not count. Why: beads make one of eight wide. */
	static final int MANY_LOOKS = 5;

	/**
	 * [ratio] Lines whose width high up is more of that low down are blunt, and are not binned as if
	 * they were as wide as they look. Why: that of a Gaussian is 0.46, up to 0.5 in noise; of lines
	 * whose light does not add up, or that were cut off, it is 0.55 and more.
	 */
	static final double BLUNT = 0.52;

	private SkeletonTuning() {
	}
}
