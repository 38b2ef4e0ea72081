package io.github.knotresolver.session;

/**
 * The numbers by which a movie is prepared and judged before and after its filaments are
 * resolved. Working pixels are those after binning. {@code scripts/ablation} measures what
 * halving and doubling each does.
 */
final class SessionTuning {

	/**
	 * [share] A frame shows no light if where the frames around it have their line less than this
	 * part of its light is left. Why: a fading or bleached line keeps more from frame to frame; a
	 * shutter leaves none.
	 */
	static final double NO_LIGHT = 0.25;

	/**
	 * [px] ... and the line may have moved so far, in working pixels. Why: a filament that is
	 * compared with a nearby frame beats no farther, and wider bands hold more background than
	 * line.
	 */
	static final int BLANK_MOTION = 8;

	/**
	 * [share] A movie is cut off if more pixels have the largest value than come within this part
	 * of the range below it. Why: peaks thin out towards their top, a ceiling gathers what is above
	 * it.
	 */
	static final double BELOW_CEILING = 0.1;

	/**
	 * [share] ... and more of all pixels than this. Why: filaments cover about a percent of a
	 * picture; a few saturated pixels are beads.
	 */
	static final double CLIPPED_PIXELS = 0.003;

	/**
	 * [share] ... or more of those along the lines than this. Why: crossings alone saturate less of
	 * a line.
	 */
	static final double CLIPPED_LENGTH = 0.25;

	/**
	 * [noise sigma] Lines of a lower clarity are called faint. Why: below it gaps and false pieces
	 * become frequent.
	 */
	static final double FAINT = 5;

	/**
	 * [share] A line of this part of the longest one's length is an object of its own. Why: debris
	 * and pieces of a broken line are shorter.
	 */
	static final double OBJECT = 0.4;

	/**
	 * [px] So many working pixels are kept around what was found. Why: a filament may reach a
	 * little beyond what is seen of it, and fits look at the background beside it.
	 */
	static final int BOX_MARGIN = 24;

	/**
	 * [px] A filament is meant that passes this near to the place that a person shows. Why: people
	 * click on the line, and a mouse is no steadier.
	 */
	static final double SHOWN_EXCHANGE = 4;

	/**
	 * [pictures] No filament is longer than so many times the picture's width and height together.
	 * Why: wound up more densely, its strands could not be told apart; it is more often a wrong
	 * unit.
	 */
	static final double LONGEST_TOLD = 6;

	/**
	 * [line widths] Light is kept so far beyond the mask of a line. Why: a Gaussian has faded there
	 * to a percent.
	 */
	static final double HALO = 3;

	/**
	 * [share] A stretched frame of more noise, in parts of its range, is blurred before the
	 * threshold. Why: single pixels would pass it.
	 */
	static final double NOISY_FRAME = 0.15;

	/** [px] ... by this. Why: that calms noise to a quarter and widens a line by a tenth. */
	static final double CALM_FRAME = 1;

	/**
	 * [frames] So many frames tell how noisy a movie is, about. Why: a median of five is not misled
	 * by one.
	 */
	static final int NOISE_FRAMES = 5;

	/**
	 * [frames] The check before the work looks at so many frames. Why: it answers within a second
	 * or two, and a share of a twelfth is fine enough to warn.
	 */
	static final int CHECKED = 12;

	/**
	 * [share] A preview takes a movie for one with one filament if so many of the frames show one
	 * object only. Why: debris and gaps spoil some.
	 */
	static final double PREVIEW_SINGLE = 0.7;

	/** [share] ... and so many its end in place. Why: a clamp is covered now and then. */
	static final double PREVIEW_CLAMPED = 0.6;

	/**
	 * [px] ... within this, in working pixels. Why: skeletons end within two pixels, and fields
	 * drift.
	 */
	static final double PREVIEW_END = 6;

	/**
	 * [px] Corners of a trail that is shown are smoothed by this. Why: pixels make a staircase of a
	 * width.
	 */
	static final double LOOK_SMOOTH = 2;

	/** [px] ... and shorter trails are not shown. Why: they are spurs and specks. */
	static final double LOOK_SHORTEST = 8;

	/**
	 * [px] A contour ends in the open if an end of the skeleton is so near. Why: smoothing and
	 * spurs shorten trails by two pixels or three.
	 */
	static final double LOOK_OPEN = 4;

	/** [probability] A contour that is surer is more likely right than wrong. Why: half way. */
	static final double LIKELY = 0.5;

	/**
	 * [share] A result of which fewer contours are likely right is told to be doubtful. Why: movies
	 * of the kind that can be resolved lose a tenth to a third of their frames in bad conditions,
	 * not two thirds.
	 */
	static final double LIKELY_SHARE = 1 / 3.0;

	/**
	 * [share] No contour is surer than so many times the share of contours that are likely right,
	 * or than half way.
	 * Why: where four of ten are in doubt one wrong length or end may be behind all, and the rest
	 * is not believed (0.9); where fewer are it is the frames themselves.
	 */
	static final double SURE_BY_OTHERS = 1.5;

	/**
	 * [px] What moves by less on average stands still. Why: contours of the same filament are found
	 * again within that.
	 */
	static final double STILL = 0.5;

	/** [frames] Fewer frames say nothing about movement. Why: a pause is as long. */
	static final int VERDICT_FRAMES = 5;

	/** [frames] So many tell what stays in a movie. Why: in a tenth of them three are dark. */
	static final int STILL_FRAMES = 32;

	/** [frames] ... and fewer than this do not. Why: a filament may rest for as long. */
	static final int FEWEST_STILL_FRAMES = 10;

	/**
	 * [strands] A hot pixel is so much brighter than those around it. Why: less hardly moves a
	 * contour, and lines themselves are uneven by as much.
	 */
	static final double HOT = 0.5;

	/**
	 * [strands] A still spot that is as bright as this dazzles. Why: of a strand of 100 photons its
	 * own noise is a fifth, and what is wrong with its profile as much.
	 */
	static final double DAZZLING = 4;

	/**
	 * [px] A contour that comes so near to a place that was told passes it. Why: a mouse is no
	 * steadier.
	 */
	static final double PASSES = 0.25;

	/**
	 * [rounds] So often a contour is bent again at most. Why: bending to one place moves it off
	 * another that is near, by less each time.
	 */
	static final int BEND_ROUNDS = 40;

	private SessionTuning() {
	}
}
