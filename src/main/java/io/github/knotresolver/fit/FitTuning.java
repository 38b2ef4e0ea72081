package io.github.knotresolver.fit;

/**
 * The numbers by which chains are fitted to light. Brightness is in strands: 1 is that of a
 * single one. A line width is the standard deviation of the line's profile. {@code
 * FitSettings} has the weights of the energy. {@code scripts/ablation} measures what halving
 * and doubling each does.
 */
final class FitTuning {

	/**
	 * [strands] What is drawn darker than this is not drawn. Why: it is far below any camera's
	 * noise.
	 */
	static final double DRAWN_DARK = 1e-4;

	/**
	 * [share] Light that fades by less over the movie is left as it is. Why: the estimate is
	 * hardly surer.
	 */
	static final double BLEACHED = 0.1;

	/**
	 * [px] Distance of the knots of the profile along the filament. Why: dyes vary over more than
	 * a micrometre; closer knots learn noise.
	 */
	static final double KNOT_SPACING = 12;

	/**
	 * [px] A profile has a knot so near to its ends. Why: an end tapers within a few line widths, and
	 * where it ends depends on how bright it is there.
	 */
	static final double END_KNOT = 2.5;

	/** [px] ... a second one so far from them. Why: about as far from the first. */
	static final double SECOND_END_KNOT = 5;

	/** [px] ... and a third. Why: half way to the usual spacing. */
	static final double THIRD_END_KNOT = 8;

	/**
	 * [spacings] ... as far as they are within this part of the usual spacing. Why: knots that
	 * nearly fall together say nothing more.
	 */
	static final double END_KNOTS_ROOM = 0.75;

	/**
	 * [strands²] These are held straight as much as others if a pixel's misfit is so large, and less
	 * where it is smaller. Why: what is seen clearly needs no holding.
	 */
	static final double END_MISFIT = 0.05;

	/**
	 * [frames] Fewer do not tell whether an end tapers. Why: two may have the same neighbour beyond
	 * it.
	 */
	static final int FEWEST_TAPERS = 5;

	/**
	 * [strands] Light beyond an end of which half of the frames have so much belongs to it. Why: a
	 * blunt end leaves 0.02.
	 */
	static final double TAPER_BRIGHT = 0.06;

	/**
	 * [noise sigma] ... if it is so sure in all frames together. Why: the best of seven headings
	 * reaches four where there is nothing.
	 */
	static final double TAPER_SURE = 6.5;

	/** [knots] A profile has at least so many. Why: a cubic has four. */
	static final int FEWEST_KNOTS = 4;

	/** [knots] ... and at most so many. Why: a few frames teach no more. */
	static final int MOST_KNOTS = 12;

	/**
	 * [weight] How much a profile is held straight. Why: so that a knot under a crossing follows
	 * its neighbours.
	 */
	static final double PROFILE_HOLD = 5;

	/** [weight] ... and near 1. Why: only where nothing else is known. */
	static final double PROFILE_PULL = 0.02;

	/**
	 * [weight] ... where the light of all frames is known. Why: drawn nearer to 1, a tip of a fifth of
	 * that looks a third as bright as the middle and ends half a pixel early.
	 */
	static final double LENGTHENED_PULL = 0.004;

	/**
	 * [strands] A profile that varies by less is even. Why: the model of the line is not better
	 * than that.
	 */
	static final double UNEVEN = 0.15;

	/**
	 * [strands] A filament with a dimmer end is not even, either. Why: haze at an end takes a sixth
	 * of its brightness, and a tapering one loses most of it.
	 */
	static final double DIM_END = 0.7;

	/** [strands] No part of a filament is dimmer. Why: its end could not be told from background. */
	static final double DIMMEST = 0.15;

	/** [strands] ... or brighter. Why: that would be two strands. */
	static final double BRIGHTEST = 2;

	/**
	 * [links] Links so near along the chain do not count as another strand. Why: they overlap
	 * where they join.
	 */
	static final int NEAR_LINKS = 3;

	/**
	 * [px] Length of a link. Why: a few line widths bend by little, and half as many links take a
	 * quarter of the time.
	 */
	static final double LINK = 3;

	/** [links] A chain has at least so many. Why: fewer cannot make an S. */
	static final int FEWEST_LINKS = 8;

	/**
	 * [links] ... and that of a filament that is clamped so many. Why: it winds up, and a short one
	 * needs them for its loops.
	 */
	static final int CLAMPED_LINKS = 45;

	/**
	 * [line widths] Length of a piece of line that is laid on at an end. Why: shorter ones are no
	 * line yet, longer ones bend.
	 */
	static final double PIECE = 3;

	/**
	 * [noise sigma] A piece is there if its brightness is so many of its standard errors. Why:
	 * seven headings are tried, and noise reaches three or four.
	 */
	static final double PIECE_SURE = 5;

	/**
	 * [strands] ... and this part of the end's. Why: what is dimmer is debris or another filament
	 * out of focus.
	 */
	static final double PIECE_BRIGHT = 0.3;

	/**
	 * [strands] A last piece with less than this is dark. Why: below {@code PIECE_BRIGHT}, so that
	 * an end does not go to and fro.
	 */
	static final double PIECE_DARK = 0.25;

	/**
	 * [share] A piece of which less is inside the frame and not hidden says nothing. Why: its
	 * brightness would be a guess.
	 */
	static final double PIECE_SEEN = 0.2;

	/** [pieces] No end moves by more. Why: a longer way is another filament. */
	static final int MOST_PIECES = 60;

	/**
	 * [links] The direction of an end is taken over so many links. Why: one is noisy, three bend.
	 */
	static final int END_LINKS = 2;

	/**
	 * [strands] Noise below this cannot be told from errors of the model. Why: the model of the
	 * line is right to some percent.
	 */
	static final double END_NOISE = 0.03;

	/**
	 * [rounds] How often line and curves are estimated in turns. Why: the curves follow the line,
	 * and the line hardly changes after the second.
	 */
	static final int LINE_ROUNDS = 3;

	/**
	 * [rounds] How often contours that may end too early are followed to the end of their light.
	 * Why: the line is known better once they are.
	 */
	static final int ENDING_ROUNDS = 3;

	/**
	 * [strands²] Of several ways through a skeleton those that are so much dearer than the best are
	 * not followed any farther. Why: the line hardly changes once it was learned along the best.
	 */
	static final double OTHER_WAY = 12;

	/** [px] ... nor those that come so near to a better one, on average. Why: they are one. */
	static final double SAME_WAY = 1;

	/**
	 * [strands²/px²] Price of leaving the place where a skeleton begins, of a filament that lies
	 * on itself. Why: 1 / (2 variance), skeletons begin within 1.5 px.
	 */
	static final double START_HELD = 0.2;

	/**
	 * [strands] A filament that is dimmer than this between its ends is not one filament there. Why:
	 * speckle leaves more, and a dim end is one.
	 */
	static final double GAP = 0.4;

	/** [ratio] ... if it is so much brighter on both sides. Why: a tapered end is so on one only. */
	static final double BEYOND_GAP = 2;

	/**
	 * [frames] Where the filament lies on itself in all frames that are looked at, fewer leave its
	 * length a guess. Why: in one of them a wrong way through itself, or to something beside it, is as
	 * likely as the right one.
	 */
	static final int FEWEST_CLOSED = 2;

	/**
	 * [strands] An end that is brighter is a guess. Why: a bead beside it makes it so, speckle of a
	 * third of the brightness seldom does.
	 */
	static final double BRIGHT_END = 1.6;

	/**
	 * [ratio] An end is a guess, too, if it is so much brighter than the dimmest place within
	 * {@code KNOT_SPACING} of it. Why: a spot that a curve was led to over a gap of less than a few
	 * line widths; knots half that far apart leave 0.6 of what is dark.
	 */
	static final double SPOT_AT_END = 1.5;

	/**
	 * [ratio] ... and what is before that place, within twice that, is so much brighter than it. Why:
	 * where nothing is brighter before it, the filament becomes dimmer towards its middle.
	 */
	static final double BEFORE_SPOT = 1.3;

	/**
	 * [ratio] An end that is so much dimmer than the filament is {@code THIRD_END_KNOT} before it
	 * is none of the filament's: haze that curves were led on into. Why: a tip that is dimmer by
	 * 80 % is reached over the filament's length, and keeps 0.7 of what it is there.
	 */
	static final double FADED_END = 0.4;

	/**
	 * [rounds] Rounds in which the profile along the filament is learned, at least. Why: the
	 * length follows the profile.
	 */
	static final int FEWEST_PROFILE_ROUNDS = 3;

	/** [rounds] ... and at most. Why: what has not settled then goes to and fro. */
	static final int MOST_PROFILE_ROUNDS = 24;

	/**
	 * [share] The length has settled if it changes by less. Why: it is known to several times
	 * that.
	 */
	static final double PROFILE_SETTLED = 3e-4;

	/**
	 * [share] Curves are equally long if half of them differ by less from the usual length. Why: one
	 * that grows does so by more in a movie.
	 */
	static final double ONE_LENGTH = 0.025;

	/**
	 * [strands²] ... and all light is known if no more than this is left of it beside noise. Why: of
	 * lines that fade over their length half of that is, of worms, which taper, up to twice as much, of
	 * clouds of haze eight times.
	 */
	static final double FADING_MISFIT = 0.005;

	/** [px] A tip that is looked for in all frames moves so far at a time. Why: a line's width. */
	static final double TIP_STEP = 1;

	/**
	 * [frames] So many frames are enough to learn the line. Why: each has hundreds of pixels along
	 * it.
	 */
	static final int LINE_EXAMPLES = 5;

	/**
	 * [share] A fitted frame whose length is farther off does not vote. Why: fits of open frames
	 * agree to less.
	 */
	static final double LENGTH_OUTLIER = 0.06;

	/**
	 * [frames] So many lengths must agree for their spread to say something. Why: two may agree by
	 * chance.
	 */
	static final int FEWEST_VOTES = 3;

	/** [px] What is wider is not a line. Why: evidence is binned before a line gets that wide. */
	static final double WIDEST_LINE = 5.5;

	/**
	 * [power] A profile with a smaller power is a Gaussian. Why: the power of a Gaussian is 1,
	 * known to some percent.
	 */
	static final double FLAT_POWER = 1.06;

	/** [px] The width with which the search begins. Why: the usual one after binning. */
	static final double FIRST_WIDTH = 1.8;

	/**
	 * [rad] A link turns by this at most in a step. Why: the picture is linear in the angle up to
	 * about half a radian.
	 */
	static final double LARGEST_TURN = 0.5;

	/**
	 * [share] The length changes by this at most in a step. Why: a tip must not jump over a
	 * neighbouring strand.
	 */
	static final double LARGEST_STRETCH = 0.1;

	/**
	 * [steps] So many shorter steps are tried before a fit gives up. Why: each is damped ten times
	 * more.
	 */
	static final int ATTEMPTS = 7;

	/**
	 * [px] The residual is looked at within this distance of the chain. Why: the line and its
	 * flanks.
	 */
	static final double QUALITY_RADIUS = 7;

	/**
	 * [strands] A stretch with less light runs in the dark. Why: half way from nothing to a
	 * strand, less what noise adds.
	 */
	static final double DARK_STRAND = 0.35;

	/**
	 * [px] Pixels farther from the curve are not looked at. Why: the line has ended there, and the
	 * background shows.
	 */
	static final double LINE_RADIUS = 9;

	/** [px] The line is at least so wide. Why: a pixel shows nothing finer. */
	static final double SMALLEST_WIDTH = 0.7;

	/** [px] ... and at most so wide. Why: what is wider is binned. */
	static final double LARGEST_WIDTH = 6;

	/**
	 * [power] The profile's power is at least that of a Gaussian. Why: no lens makes a sharper
	 * peak.
	 */
	static final double SMALLEST_POWER = 1;

	/** [power] ... and at most this. Why: that is a box already. */
	static final double LARGEST_POWER = 6;

	/**
	 * [steps] The search for width and power ends after so many. Why: two numbers to three digits.
	 */
	static final int SEARCH_STEPS = 120;

	/**
	 * [line widths] A strand is drawn so far to its sides where strands add up. Why: the rest is
	 * 0.01 % of it.
	 */
	static final double ADDITIVE_REACH = 4.2;

	/**
	 * [line widths] ... and so far in scenes. Why: the rest is 0.4 %, below the noise, and a scene
	 * is drawn often.
	 */
	static final double SCENE_REACH = 3.3;

	/**
	 * [px] Light within this distance of the chain is near. Why: a tip that was cut off, a strand
	 * that was missed beside it.
	 */
	static final double RESIDUE_NEAR = 10;

	/** [px] Pixels within this distance are around the chain. Why: the line and its flanks. */
	static final double RESIDUE_AROUND = 6;

	/** [strands] A line of this brightness is seen. Why: fainter ones are debris. */
	static final double RESIDUE_SEEN = 0.25;

	/**
	 * [noise sigma] ... if it is as far above the noise. Why: noise alone does not reach it near a
	 * chain.
	 */
	static final double RESIDUE_NOISES = 5;

	/**
	 * [strands] Residuals beyond this count as this. Why: one bead must not count for all of the
	 * chain.
	 */
	static final double RESIDUE_OUTLIER = 0.5;

	/**
	 * [strands] Noise below this cannot be told from errors of the model. Why: the model of the
	 * line is right to some percent.
	 */
	static final double RESIDUE_NOISE = 0.05;

	/**
	 * [strands] Residuals much beyond this do not pull. Why: they belong to another strand, whose
	 * brightness is 1.
	 */
	static final double ROBUST = 0.35;

	/**
	 * [px] Room around a filament in the part of the frame in which it is fitted. Why: a filament
	 * moves by less between frames, and its light ends within.
	 */
	static final double WINDOW_ROOM = 12;

	/**
	 * [px] The largest piece that is added straight on at a tip. Why: a skeleton ends about half a
	 * width early; what is missing beyond lies elsewhere.
	 */
	static final double EXTENSION = 8;

	/**
	 * [px] The direction of a tip is taken over this length. Why: a skeleton's last pixels are
	 * crooked.
	 */
	static final double TIP_DIRECTION = 6;

	/**
	 * [headings] Headings of a link relative to the one before: so many. Why: to 1.8 rad on either
	 * side, more than a filament turns in a link.
	 */
	static final int HEADINGS = 13;

	/** [rad] ... so far apart. Why: a fit finds what lies between. */
	static final double HEADING_STEP = 0.3;

	/**
	 * [tips] So many tips are kept from link to link. Why: all that differ by more than a heading
	 * within a few links.
	 */
	static final int BEAM = 12;

	/** [tips] ... and so many are given. Why: each is fitted afterwards, which takes the time. */
	static final int BEAM_GIVEN = 4;

	/**
	 * [share] Price of a turn against the light, as a share of the stiffness. Why: tips bend more
	 * than the rest.
	 */
	static final double BEAM_TURN = 0.5;

	private FitTuning() {
	}
}
