package io.github.knotresolver.image;

/**
 * The numbers by which a frame becomes evidence. A line width is the standard deviation of the
 * line's profile, a noise sigma the standard deviation of the ridge strength where there is no
 * line. {@code scripts/ablation} measures what halving and doubling each does.
 */
final class ImageTuning {

	/**
	 * [px] Edge of a cell of the background; a cell is the mean of its pixels. Why: a background
	 * varies over tens of pixels, and a cell saves 15 of 16.
	 */
	static final int CELL = 4;

	/**
	 * [share] A Gaussian has enough pixels if so many of those under it are background. Why: with
	 * fewer its mean hangs on one side.
	 */
	static final double ENOUGH = 0.15;

	/**
	 * [noise sigma] Pixels farther than this from the background are not part of it. Why: of a
	 * thousand pixels of noise alone fewer than one is.
	 */
	static final double OUTLIER = 3.5;

	/**
	 * [rounds] How often outliers are left out. Why: the first round takes the filaments away, the
	 * second their halo.
	 */
	static final int BACKGROUND_ROUNDS = 2;

	/**
	 * [share] A spot curves along by more than this part of what it curves across. Why: a line
	 * does not curve along, a round spot does by as much; half way.
	 */
	static final double ROUND = 0.5;

	/**
	 * [line widths] A spot and what its light does to the ridges around reach so far. Why: a spot
	 * as wide as the line has faded there.
	 */
	static final double SPOT_REACH = 3;

	/**
	 * [strands] A still spot is so much brighter than the lines that run through it. Why: the fixed
	 * end of a filament that turns around it is a still spot of one strand at most.
	 */
	static final double SPOT_BRIGHT = 1.25;

	/**
	 * [strands] ... and one beside a brighter spot is as bright as this. Why: that one hides a part
	 * of it.
	 */
	static final double SPOT_HIDDEN = 0.75;

	/**
	 * [line widths] Spots so near are beside each other. Why: there one spot's light has faded.
	 */
	static final double SPOT_BESIDE = 3.5;

	/**
	 * [strands] What is left of a spot that was taken off is taken off, too, if it is as bright as
	 * this. Why: as much as noise and a profile that is not quite round leave of a bright one.
	 */
	static final double SPOT_LEFT = 0.2;

	/**
	 * [line widths] ... and lies so near to its middle. Why: two spots that touch are taken for one
	 * between them first.
	 */
	static final double SPOT_SAME = 2.5;

	/**
	 * [share] A spot curves along by more than this part of what it curves across. Why: two spots
	 * that touch hardly do, and a line, which does not at all, is told by what goes on beyond.
	 */
	static final double SPOT_ROUND = 0.1;

	/**
	 * [share] A spot is as bright as it is in all but this share of the directions. Why: two arms
	 * of a line and a neighbour cover less than the rest.
	 */
	static final double SPOT_ALONE = 0.3;

	/**
	 * [noise sigma] A hot pixel is so much brighter than what surrounds it says. Why: of a million
	 * pixels none is by chance.
	 */
	static final double STUCK_NOISE = 8;

	/**
	 * [share] ... and it is brighter than its second brightest neighbour by so many times what
	 * that is brighter than the darkest. Why: of a spot with a sigma of 0.8 px, the sharpest that a
	 * lens draws on a camera, it is 1.2 times.
	 */
	static final double STUCK_ALONE = 2;

	/**
	 * [share] A pixel is free of lines in at least this share of the frames. Why: a filament lies
	 * on its usual track nearly all the time, and of ten frames one tells.
	 */
	static final double STILL_FREE = 0.1;

	/**
	 * [line widths] The profile across a line reaches so far to both sides. Why: there a line has
	 * ended, and a neighbour not begun.
	 */
	static final double PROFILE_REACH = 4;

	/**
	 * [px] Fewer pixels of skeleton give no profile. Why: a median of fewer is as noisy as the
	 * pixels.
	 */
	static final int FEWEST_CREST = 20;

	/** [px] The largest block that is looked for. Why: people enlarge by eight at most. */
	static final int LARGEST_BLOCK = 8;

	/**
	 * [share] So many neighbours within blocks are alike in a picture of blocks. Why: the rest may
	 * be a label that was drawn in.
	 */
	static final double ALIKE_IN_BLOCKS = 0.98;

	/**
	 * [share] In a smoothly enlarged picture neighbours differ by less than this part of what
	 * pixels farther apart do. Why: in noise they differ as much.
	 */
	static final double SMOOTHED = 0.5;

	/**
	 * [px] "Farther apart" is so far. Why: farther than what one pixel becomes when enlarged
	 * twice.
	 */
	static final int APART = 3;

	/** [px] The thinnest line that pixels can show. Why: finer lines fall between the pixels. */
	static final double THINNEST_LINE = 0.7;

	/**
	 * [px] A wide line is binned until it is about so wide. Why: that samples it well, and a fit takes
	 * as much longer as the square of the width; much narrower, strands that lie side by side melt.
	 */
	static final double COARSE_LINE = 1.4;

	/** [px] The narrowest filter. Why: narrower ones are no derivatives of Gaussians on pixels. */
	static final double NARROWEST_FILTER = 0.8;

	/**
	 * [noise sigma] The clarity that is taken until it is measured. Why: between faint (5) and
	 * clear (12).
	 */
	static final double USUAL_CLARITY = 8;

	/**
	 * [noise sigma] From this clarity on the filter may be narrower than the line. Why: noise does
	 * not matter then, and narrow filters part strands.
	 */
	static final double CLEAR_LINE = 12;

	/** [line widths] ... down to this. Why: narrower filters see a line's two edges. */
	static final double NARROW_FILTER = 0.7;

	/**
	 * [line widths] ... and of faint lines up to this. Why: wider filters gain nothing: the line
	 * has ended.
	 */
	static final double WIDE_FILTER = 1.75;

	/** [px] Smaller pictures are not looked at. Why: a filter does not fit in. */
	static final int SMALLEST_PICTURE = 12;

	/**
	 * [noise sigma] A pixel votes for a line if it is stronger than this. Why: above what noise
	 * makes in a frame.
	 */
	static final double VOTE_NOISE = 6;

	/**
	 * [share] ... and than this part of the range of brightness. Why: a picture without noise has
	 * rounding errors.
	 */
	static final double VOTE_RANGE = 1e-4;

	/**
	 * [share] The smaller drop to the sides is more than this part of the mean drop. Why: an edge
	 * drops to one side only.
	 */
	static final double VOTE_BALANCE = 0.25;

	/**
	 * [filter sigma] A line is at least so long. Why: a spot is as long as the filter makes it,
	 * three to four.
	 */
	static final double VOTE_LENGTH = 8;

	/**
	 * [share] From this share of the vote on, the other sign makes the polarity doubtful. Why:
	 * half as many votes are more than a halo gives.
	 */
	static final double VOTE_DOUBT = 0.5;

	/**
	 * [px] Edge of a tile in which noise is measured, about. Why: some 250 of its pixels are
	 * looked at, enough for a quantile, and noise varies over more.
	 */
	static final int NOISE_TILE = 48;

	/**
	 * [share] Noise is measured from this quantile of the magnitudes. Why: filaments may cover
	 * more than half of a tile before they touch it.
	 */
	static final double NOISE_QUANTILE = 0.4;

	/**
	 * [times] A tile's noise is held within this factor of the middle one. Why: shot noise of a
	 * background that is nine times brighter.
	 */
	static final double NOISE_FACTOR = 3;

	/**
	 * [share] The noise is at least this part of the largest response. Why: a movie may have none.
	 */
	static final double LEAST_NOISE = 1e-3;

	/**
	 * [share] An edge has a negative lobe of this part of its strength on one side. Why: a line
	 * has one on either side.
	 */
	static final double LOBE = 0.5;

	/** [share] ... and none of this part on the other. Why: noise makes some. */
	static final double NO_LOBE = 0.1;

	/**
	 * [filter sigma] The average along the line is a Gaussian of this width. Why: longer ones miss
	 * bends, shorter ones leave noise.
	 */
	static final double ALONG = 1.5;

	/** [its own sigma] ... and ends here. Why: the rest is five percent. */
	static final double ALONG_REACH = 2;

	/**
	 * [noise sigma] A line is at least as strong as this. Why: weaker ones are noise more often
	 * than not; what is faint must be long, too.
	 */
	static final double LOW = 2.5;

	/**
	 * [share] ... and as this part of the usual strength. Why: the out-of-focus neighbour of a
	 * bright filament is about as faint.
	 */
	static final double LOW_SHARE = 0.1;

	/**
	 * [noise sigma] A line that is beyond doubt is as strong as this. Why: noise does not reach it
	 * in a frame.
	 */
	static final double HIGH = 5;

	/**
	 * [share] ... and as this part of the usual strength. Why: a filament's own unevenness does
	 * not go that low.
	 */
	static final double HIGH_SHARE = 0.25;

	/**
	 * [share] A pixel belongs to a line if it has this part of the largest strength nearby. Why:
	 * the flank of a line has less, its neighbour strand more.
	 */
	static final double RELATIVE = 0.4;

	/**
	 * [share] ... or, on a crest, this part. Why: a crest is a line of its own, however faint
	 * beside a brighter one.
	 */
	static final double RELATIVE_ON_CREST = 0.2;

	/**
	 * [px²] The variance of a line is at least this. Why: half a pixel is the finest that pixels
	 * can show.
	 */
	static final double LEAST_VARIANCE = 0.25;

	private ImageTuning() {
	}
}
