package io.github.knotresolver.track;

/**
 * The numbers by which the fits of all frames become tracks. Brightness is in strands: 1 is
 * that of a single one; a usual motion is what the filament moves from frame to frame at the
 * median. Prices of the trellis are in strands squared, as the energy of a fit. {@code
 * scripts/ablation} measures what halving and doubling each does.
 */
final class TrackTuning {

	/**
	 * [px] Contours that lie nearer to each other, on average at equal arc length, are one to the
	 * eye. Why: a line is about that wide.
	 */
	static final double VISIBLE = 2.5;

	/**
	 * [price] A gap of this price takes 63 % of a rival's weight. Why: the noise of a fit's
	 * energy.
	 */
	static final double GAP_SCALE = 2;

	/**
	 * [logit] A figure that lowers the logit by less is not told as a reason. Why: it halves the
	 * odds.
	 */
	static final double REASON = 0.7;

	/**
	 * [probability] Below this a contour cannot be called resolved. Why: one in ten thousand is
	 * right.
	 */
	static final double NO_CONFIDENCE = 0.0001;

	/**
	 * [price] Price of usual motion between skeletons, in px. Why: skeletons are noisy, so one
	 * good guess must not outweigh its neighbours.
	 */
	static final double SKELETON_MOTION = 16;

	/**
	 * [price] A gap of this price, in px, gives a confidence of 63 %. Why: as much skeleton is
	 * easily left out.
	 */
	static final double SKELETON_GAP = 10;

	/**
	 * [line widths] A place that a person shows is meant to within this. Why: people click on the
	 * line.
	 */
	static final double SHOWN_WIDTHS = 2;

	/** [px] ... but no better than this. Why: a mouse is not steadier. */
	static final double SHOWN_LEAST = 3;

	/** [px] The usual motion is at least this. Why: fits are no better. */
	static final double LEAST_MOTION = 0.5;

	/** [rad] The usual turn is at least this. Why: fits are no better. */
	static final double LEAST_TURN = 0.05;

	/**
	 * [ratio] Lengths whose ratio is above this differ. Why: below, arc lengths agree to a link.
	 */
	static final double OTHER_LENGTH = 1.005;

	/**
	 * [price] Price of usual motion. Why: far below what a strand in the dark costs, so that light
	 * decides where there is any.
	 */
	static final double USUAL_MOTION = 0.2;

	/**
	 * [price] Price of each further multiple of usual motion. Why: ten times usual motion costs as
	 * much as seven pixels of strand in the dark.
	 */
	static final double FURTHER_MOTION = 0.7;

	/**
	 * [px] Spacing of the points at which skeletons' contours are compared. Why: skeletons are
	 * smooth over that.
	 */
	static final double DISTANCE_STEP = 4;

	/**
	 * [px] Pairs are warped up to this much beyond the nearest one's distance. Why: farther ones
	 * cannot become the nearest.
	 */
	static final double WARP = 12;

	/** [px] Motion of a skeleton below this is noise. Why: skeletons go from pixel to pixel. */
	static final double SKELETON_NOISE = 1;

	/**
	 * [usual motion] From this on, a longer jump is hardly worse than a shorter. Why: what jumps
	 * has been lost, wherever it went.
	 */
	static final double JUMP = 5;

	/**
	 * [share] This part of the last step is expected to go on. Why: a beating filament slows down
	 * and turns.
	 */
	static final double INERTIA = 0.7;

	/** [px] Motion below this needs no start of its own. Why: a fit finds what is that near. */
	static final double SLOW = 0.75;

	/**
	 * [price] A hypothesis that is this much more expensive than the best is dropped. Why: one
	 * frame does not make up for it.
	 */
	static final double HOPELESS = 12;

	/**
	 * [probability] A contour that is less sure is doubtful. Why: it is rather wrong than right.
	 */
	static final double DOUBTFUL = 0.5;

	/** [episodes] So many doubtful episodes are told. Why: a person reads no more. */
	static final int EPISODES = 10;

	/**
	 * [frames] Light says of so many frames at least where the end is, or the skeletons do. Why:
	 * fewer have no spread.
	 */
	static final int SETTLING = 5;

	/**
	 * [share] ... and the middle half of these frames is so much of the movie. Why: what holds for
	 * half of an eighth of it need not hold for the rest.
	 */
	static final double SETTLING_SPAN = 0.125;

	/** [px] A skeleton ends so much before the filament does. Why: half a usual width. */
	static final double SKELETON_SHORT = 2;

	/**
	 * [px] An end that stays is seen within this distance in half of the frames. Why: a contour that
	 * was rounded to pixels before it was drawn is off by up to that; fits of an end agree better.
	 */
	static final double STILL_END = 1;

	/**
	 * [1] An end drifts that goes so many times farther than it strays from its way. Why: between places
	 * that are rounded to pixels it strays as far as it goes; a stage that drifts goes straight.
	 */
	static final double STEADY = 4;

	/**
	 * [px] ... as skeletons see it, within this. Why: they end a pixel or two earlier or later.
	 */
	static final double STILL_SKELETON = 3;

	/** [share] ... and within twice of that in this share of them. Why: some frames are wrong. */
	static final double STILL_SHARE = 0.9;

	/**
	 * [px] Standard deviation of an end as a fit of an open frame says. Why: the fit's own, in the
	 * dark beyond the end.
	 */
	static final double LIGHT_NOISE = 0.3;

	/**
	 * [px] ... as any fit says that is not held. Why: some are crossed, and a dim end is seen to a
	 * pixel only.
	 */
	static final double FIT_NOISE = 0.5;

	/**
	 * [1] Two frames tell how late a filament begins if its directions at the clamp, of length 1, are so
	 * far apart. Why: nearer ones tell more of the noise of its start.
	 */
	static final double PIVOT_TURNED = 0.5;

	/** [frames] So many say it, of more some that are spread evenly. Why: a median needs no more. */
	static final int PIVOT_FRAMES = 500;

	/**
	 * [ratio] It turns around a place that stays if its starts, as much earlier, are within so much of
	 * what they were. Why: a clamp that moves by itself is as far off in any direction.
	 */
	static final double PIVOT_BETTER = 0.5;

	/**
	 * [noise] ... An end that was thought to stay moves if contours that are not held are usually so
	 * many times better as noise makes them. Why: it makes one in seven so much better.
	 */
	static final double SURELY_ELSEWHERE = 2;

	/**
	 * [frames, share] ... and nearer than {@code STILL_SKELETON} in so many of them. Why: farther off
	 * skeletons would have seen it; a filament beside the clamp takes contours with it.
	 */
	static final double NEAR_STILL = 0.9;

	/** [px] ... as a skeleton says. Why: see {@code SKELETON_SHORT}. */
	static final double END_NOISE = 1.5;

	/**
	 * [strands] Frames of more noise are blurred before they are fitted. Why: a fit would follow
	 * single pixels.
	 */
	static final double NOISY = 0.3;

	/** [px] ... by this. Why: that calms noise to a quarter and widens a line by a tenth. */
	static final double CALMING = 1;

	/**
	 * [px] A step of an end this long costs as much as its vote brings. Why: ends are noisy by
	 * less, and other ends are farther.
	 */
	static final double END_STEP = 5;

	/**
	 * [1] Ends near the place of the fixed end count so many times. Why: that end is missed in some
	 * frames, in which another one that passes by is seen.
	 */
	static final double AT_PLACE = 2;

	/** [ends] A path goes on from one of the last so many ends. Why: it bounds the work. */
	static final int END_MEMORY = 600;

	/** [px] An anchor that moves by less is not worth a note. Why: it is within the line. */
	static final double NOTED_DRIFT = 2;

	/** [px] Objects with less skeleton are specks. Why: a filament is longer than five widths. */
	static final double SPECK = 15;

	/**
	 * [share] A contour may be turned round that moved, turned round, by less than this part. Why: a
	 * filament that is held, or glides, moves far less than from one of its ends to the other.
	 */
	static final double TURN = 0.5;

	/** [probability] That contours which may be turned round are right, at most. Why: it is even. */
	static final double TURNED = 0.5;

	/**
	 * [median distances] A contour begins elsewhere if it begins so much farther from the middle of all
	 * starts than half of them do, and more than a line's width. Why: of a clamp that jitters one in
	 * thirty million does.
	 */
	static final double STRAY = 5;

	/** [frames] ... of so many. Why: most of fewer may be wrong together. */
	static final int STRAY_FEWEST = 5;

	/**
	 * [share] Where so many contours begin elsewhere, all are doubted. Why: of two places that are
	 * as usual, either may be a speck.
	 */
	static final double STRAY_OFTEN = 0.25;

	/**
	 * [share of the length] Near its start a filament goes where the clamp does. Why: farther on it
	 * beats.
	 */
	static final double NEAR_START = 0.25;

	/**
	 * [ratio] It was carried there if it went another way by less than this part. Why: a stage takes
	 * all of it along.
	 */
	static final double CARRIED = 0.3;

	/**
	 * [ratio] Which end is held is a guess if the one that is taken for it moves more than this part of
	 * what the other one does. Why: on stages that jitter by 1 px a frame it is below 0.5.
	 */
	static final double RESTLESS = 0.7;

	/**
	 * [line widths] A contour of which no more is in the picture is not given. Why: it cannot be told
	 * from a spot, and its course not at all.
	 */
	static final double SPOT = 4;

	/**
	 * [share] Weight of skeleton that lies still. Why: debris does, and a filament only near its
	 * clamp.
	 */
	static final double STILL_VOTE = 0.05;

	/** [px] An end this near to the border is cut off by it. Why: filters see no line there. */
	static final double BORDER = 4;

	/**
	 * [share] ... and its vote counts so much. Why: a clamp may lie outside, but ends that pass
	 * the border are more frequent.
	 */
	static final double AT_BORDER = 0.3;

	/**
	 * [px] The direction of an end is taken over this arc length. Why: less is a staircase, more
	 * is a bend.
	 */
	static final double END_DIRECTION = 8;

	/**
	 * [px] Ends within this distance are in the same place. Why: skeletons end within two pixels,
	 * and fields drift.
	 */
	static final double SAME_PLACE = 4;

	/**
	 * [share] A path needs this share of the best path's votes to be looked at. Why: a clamp that
	 * is hidden half of the time.
	 */
	static final double CONTENDER = 0.4;

	/**
	 * [px] Price of a path without any votes, and of one that is never in the same place. Why: as
	 * much as a trail that misses a junction.
	 */
	static final double FEWER_VOTES = 20;

	/**
	 * [px] Price of a frame in which no trail begins at a place. Why: as long as a short filament.
	 */
	static final double NO_TRAIL = 100;

	/**
	 * [px] A skeleton that is this near to a place holds it. Why: where strands cross, the
	 * skeleton lies beside them.
	 */
	static final double ASIDE = 6;

	/** [paths] So many paths are looked at. Why: a filament has two ends; the rest is debris. */
	static final int CONTENDERS = 5;

	/** [frames] ... in so many frames. Why: means of twelve differ enough. */
	static final int FRAMES_TO_TRY = 12;

	/**
	 * [lengths] So few lengths say nothing about a change. Why: a line and a break have four
	 * parameters.
	 */
	static final int COURSE_LENGTHS = 6;

	/** [lengths] ... and so few beside a break. Why: two may be wrong together. */
	static final int BESIDE_BREAK = 3;

	/**
	 * [share] Errors of lengths are at least this large. Why: fits are no better, whatever their
	 * own errors say.
	 */
	static final double LENGTH_ERROR = 0.006;

	/**
	 * [share] A change over the movie of less than this is none. Why: bleaching and focus make as
	 * much.
	 */
	static final double LENGTH_CHANGE = 0.025;

	/**
	 * [standard deviations] What is farther off is wrong, however far. Why: one in four hundred by
	 * chance.
	 */
	static final double LENGTH_OUTLIER = 3;

	/**
	 * [ln n] Price of a parameter. Why: half more than the Bayesian criterion's, since errors are
	 * correlated.
	 */
	static final double PARAMETER = 1.5;

	/**
	 * [frames] A wandering length has a parameter for so many frames. Why: it goes to and fro no
	 * faster.
	 */
	static final double WANDERING = 5;

	/** [frames] Fewer unbranched frames say nothing. Why: a median needs three. */
	static final int UNBRANCHED = 3;

	/**
	 * [standard deviations] A skeleton's length that is farther off is an outlier. Why: one in
	 * four hundred by chance.
	 */
	static final double SKELETON_OUTLIER = 3;

	/** [share] ... if by more than this. Why: skeletons are no better. */
	static final double SKELETON_TOLERANCE = 0.03;

	/** [frames] So many whole frames say how long the filament is. Why: a median needs three. */
	static final int WHOLE_FRAMES = 3;

	/**
	 * [share] With fewer frames cut by the border the estimate from the clearest frames holds.
	 * Why: a median does not mind.
	 */
	static final double CUT_FRAMES = 0.1;

	/**
	 * [standard errors] A length that all frames say together is another one if it is so far off.
	 * Why: by chance it is once in some hundred movies.
	 */
	static final double SURELY_OTHER = 3;

	/**
	 * [ratio] ... or if the other one's standard error is so many times as large. Why: it is a guess
	 * beside this one then.
	 */
	static final double KNOWN_BETTER = 2;

	/** [share] ... and by at least so much. Why: the line model is no better. */
	static final double NOTICEABLE_LENGTH = 0.003;

	/**
	 * [share] What agrees within this with the median is used. Why: fits of open frames agree to
	 * less.
	 */
	static final double WHOLE_OUTLIER = 0.06;

	/**
	 * [standard deviations] What is farther off is wrong, however far. Why: one in ten thousand by
	 * chance.
	 */
	static final double WALK_OUTLIER = 4;

	/** [rounds] So often values that are far off lose weight. Why: it settles. */
	static final int WALK_ROUNDS = 3;

	/**
	 * [frames] Medians of so many known values to both sides show a jump. Why: one of three may be
	 * wrong.
	 */
	static final int JUMP_WINDOW = 3;

	/**
	 * [standard deviations] ... if they differ by more than this. Why: noise does not in a movie.
	 */
	static final double WALK_JUMP = 6;

	/**
	 * [price] In a frame whose contour becomes cheaper by more than this once its fixed end is set
	 * free, that end may have jumped. Why: with a line's width drawn in the dark at one end and left
	 * out at the other it would be 2.5, and noise of half a strand makes it 1.
	 */
	static final double JUMPED = 2;

	/**
	 * [multiples] ... and by so many times what is usual in the movie. Why: where it gains often, the
	 * place or the line is wrong in all frames.
	 */
	static final double JUMPED_UNUSUAL = 6;

	/**
	 * [frames] So many frames are enough to learn the filament from. Why: each is fitted several
	 * times.
	 */
	static final int SIGHTINGS = 14;

	/**
	 * [frames] ... and so many of the solved movie where the filament is not evenly bright. Why: a tip
	 * of a fifth of the brightness is seen to half a pixel in a frame, and its brightness with it.
	 */
	static final int UNEVEN_SIGHTINGS = 28;

	/**
	 * [share] These are the same ends if the length is another by less. Why: a dim tip is missed by a
	 * pixel or two, something else beside it is farther away.
	 */
	static final double SAME_ENDS = 0.01;

	/**
	 * [frames] Fewer unbranched skeletons are not relied on alone. Why: two may be cut at the same
	 * place.
	 */
	static final int SIMPLE_FRAMES = 3;

	/** [px] Shorter contours are not looked at. Why: their ends are all there is. */
	static final double SIGHTED = 12;

	/**
	 * [share] The length that this share of the frames does not reach is taken. Why: a filament
	 * that hides a part of itself looks short, never long.
	 */
	static final double SIGHTED_QUANTILE = 0.8;

	/**
	 * [share] ... and frames that are within this of it. Why: skeletons of open frames agree to
	 * that.
	 */
	static final double SIGHTED_TOLERANCE = 0.06;

	/**
	 * [trails] So many other ways through the skeleton of a frame in which the filament lies on
	 * itself are fitted. Why: a loop that is closed is passed either way, and dearer ones are
	 * wrong.
	 */
	static final int OTHER_WAYS = 3;

	/**
	 * [px] A contour that ends this near to an earlier part of itself runs into itself. Why: a
	 * closed loop ends at the node at which it began, and smoothing moves it a little.
	 */
	static final double RUNS_INTO = 4;

	/**
	 * [share] A filament lies open often if it does in so many of the frames. Why: haze and hot
	 * pixels break a few closed loops open.
	 */
	static final double OFTEN_OPEN = 0.5;

	/**
	 * [share] So many of the frames must show one object with at most two ends. Why: debris and
	 * gaps spoil some.
	 */
	static final double NEARLY_ALL = 0.85;

	/** [px] Objects with less skeleton are specks. Why: a filament is longer than four widths. */
	static final double SINGLE_SPECK = 12;

	/**
	 * [share] ... or with less than this part of the longest. Why: another filament is not that
	 * short.
	 */
	static final double SINGLE_SPECK_SHARE = 0.1;

	/**
	 * [share] Of one object and much that is none, it is longer than this part of all. Why: of a field
	 * of eleven filaments the longest is a third; beside haze and beads a filament is a half.
	 */
	static final double MAIN_OBJECT = 0.5;

	/** [px] A shorter branch has no end of its own. Why: as wide as a thick line. */
	static final double SINGLE_SPUR = 8;

	/**
	 * [share] A clamped end is seen in so many open frames. Why: it moves neither away nor under
	 * the filament.
	 */
	static final double CLAMP_SEEN = 0.85;

	/** [share] ... and its steps leave it so much of its votes. Why: a gliding end loses half. */
	static final double CLAMP_VOTES = 0.55;

	/** [px] A stage moves a clamp no farther than this. Why: a filament that moves on is free. */
	static final double STAGE = 24;

	/** [frames] So many frames must show both ends. Why: fewer may be chance. */
	static final int FEWEST_OPEN = 5;

	/**
	 * [share] This quantile of the light along a skeleton is that of a single strand. Why: strands
	 * that lie on each other are brighter, and gaps are rare.
	 */
	static final double STRAND_QUANTILE = 0.3;

	/**
	 * [share] An open filament's skeleton is at least this part of the usual longest. Why: one
	 * that winds up is shorter.
	 */
	static final double OPEN_LENGTH = 0.9;

	/**
	 * [share] The usual longest is this quantile of all frames' lengths. Why: the longest itself
	 * may be wrong.
	 */
	static final double LONGEST = 0.9;

	/**
	 * [frames] So many open frames are enough to tell a change of light. Why: a slope of fewer is
	 * chance.
	 */
	static final int LIGHT_FRAMES = 4;

	/** [share] ... over this part of the movie. Why: a slope of less is chance. */
	static final double LIGHT_SPAN = 0.25;

	/**
	 * [px] Skeleton within this distance of a contour is covered. Why: two widths: where strands
	 * cross, the skeleton lies beside them.
	 */
	static final double COVERED = 5;

	/**
	 * [px] The residual is blurred by this. Why: noise of neighbouring pixels evens out, and a
	 * strand stays.
	 */
	static final double RESIDUE_BLUR = 0.8;

	/**
	 * [strands²] Squared residual at which a pixel's price begins to level off. Why: one bright
	 * spot must not decide.
	 */
	static final double RESIDUE_LEVEL = 0.25;

	/**
	 * [strands²] Below this a squared residual does not count. Why: errors of the model of the
	 * line.
	 */
	static final double RESIDUE_LEAST = 0.02;

	/** [noise sigma] ... nor below this. Why: noise. */
	static final double RESIDUE_NOISES = 3;

	/** [px] Pixels within this distance of a curve are around it. Why: the line and its flanks. */
	static final int RESIDUE_NEAR = 4;

	/**
	 * [px] From this usual motion on, a fit from where the filament was may not find it. Why: the
	 * light of a line reaches that far.
	 */
	static final double FAST = 5;

	/** [starts] So many are fitted. Why: each takes as long as a usual fit. */
	static final int WOUND_BEST = 2;

	/** [px] Starts nearer to each other than this are one. Why: they end in the same fit. */
	static final double WOUND_SAME = 2;

	/**
	 * [px] Fits nearer to each other than this on average are one. Why: they end in the same place
	 * if fitted on.
	 */
	static final double SAME_FIT = 1.0;

	/**
	 * [strands²] Contours whose movies differ in price by less than about this cost the same. Why: a
	 * link on which the model of the line is off by a fifth of a strand costs half of it.
	 */
	static final double TIE = 0.5;

	/** [probability] The confidence of what is guessed is at most this. Why: either may be right. */
	static final double GUESSED = 0.5;

	/**
	 * [line widths] A tip that is so far from the rest of the filament does not lie on it. Why: where a
	 * dim tip does, what is taken for the end is up to 1.3 from the strand beside it.
	 */
	static final double TIP_APART = 1.5;

	/**
	 * [frames] Fewer frames in nearly all of which the tip is nearer do not say how long the filament
	 * is. Why: of five, one ended before its light.
	 */
	static final int HIDDEN_FEW = 10;

	/**
	 * [frames] So many frames before and after a break show a tip that is not. Why: one may be misread.
	 */
	static final int BREAK_SHOWN = 2;

	/** [line widths] The last so many of a contour are its tip. Why: on a ring it turns by less. */
	static final double TAIL = 4;

	/** [line widths] The tip of a wide line is as long. Why: a shorter one may only cross the other. */
	static final double BESIDE_TIP = 3;

	/** [share] ... of which more than this is beside the other part. Why: one end of it may part. */
	static final double BESIDE_SHARE = 0.8;

	/**
	 * [line widths] A part of the filament that comes so much before a point is another one. Why: within
	 * this a line does not turn back.
	 */
	static final double BESIDE_APART = 3;

	/**
	 * [tip's brightness] In less noise of a pixel two lines side by side are told apart. Why: of random
	 * movies with lines as wide, such contours are wrong above this only.
	 */
	static final double BESIDE_NOISE = 0.08;

	/**
	 * [ratio] Half of a width must be this part of what is wrong. Why: the rest of the contour is off by
	 * some, too.
	 */
	static final double BESIDE_WRONG = 0.9;

	/** [px of the movie] A contour is wrong if it is off by this. Why: it is what confidences are of. */
	static final double WRONG = 5;

	/**
	 * [px] Starts nearer to each other than this on average are fitted once. Why: a fit moves them
	 * farther, and to the same place.
	 */
	static final double SAME_START = 0.25;

	/** [candidates] So many of the cheapest candidates are drawn. Why: drawing is cheap. */
	static final int DRAWN = 12;

	/**
	 * [candidates] ... and so many of those fitted. Why: prices of skeletons are rough, but hardly
	 * that rough.
	 */
	static final int FITTED = 4;

	/**
	 * [logit] What speaks for a contour against which nothing speaks. Why: fitted by scripts/fit-
	 * confidence with the weights; docs/method.md has the result.
	 */
	static final double CONFIDENT = 9;

	/**
	 * [line widths] A turn is one within this length of a contour. Why: on it a line that turns
	 * back covers itself.
	 */
	static final double TURN_WITHIN = 4;

	/** [px] ... which is no shorter than this. Why: the links of a chain are 3 px long. */
	static final double TURN_LEAST = 4;

	/**
	 * [rad] Sharper turns speak against a contour. Why: no right contour of bench/conditions.py
	 * turns by more than 1.7, while one that winds up on a spot turns back.
	 */
	static final double HARMLESS_TURN = 2;

	/** [rad] ... and one as sharp as this is as bad as it gets. Why: it nearly turns back. */
	static final double HOPELESS_TURN = 2.6;

	/**
	 * [ln] A residual so much above the noise is plain. Why: what is left of a right contour comes
	 * near it where the line model is not quite that of the object.
	 */
	static final double PLAIN_PATTERN = 0.68;

	/** [ln] ... if it is so much above that of most frames. Why: right ones differ by less. */
	static final double USUAL_PATTERN = 0.06;

	/**
	 * [ln] ... and by this beyond is as bad as it gets. Why: where the tails of a worm (wormpose40 of
	 * other people's movies) lie on each other, contours that took the wrong one are beyond it.
	 */
	static final double UNUSUAL_PATTERN = 0.03;

	/**
	 * [share] The light beyond an end, or missing at it, that says that the contour does not end
	 * there. Why: it is the half of a strand's.
	 */
	static final double ENDS_WITH_LIGHT = 0.5;

	/**
	 * [share] Contours that do not end with their light in so few of the frames say nothing. Why:
	 * noise, dim tips, beads and hot pixels do nearly as much (bench/conditions.py).
	 */
	static final double SELDOM_ENDS = 0.2;

	/**
	 * [share] ... and in so many are as bad as it gets. Why: the ends of a filament that winds up
	 * are hidden in most.
	 */
	static final double OFTEN_ENDS = 0.3;

	/**
	 * [share of the length] Lines or skeletons near a contour that are not on it and longer than this
	 * are left out. Why: it is more than what noise and beads add in most frames.
	 */
	static final double LEFT_OUT = 0.05;

	/**
	 * [share of the frames] Contours that leave out something in more are believed in none. Why: of
	 * bench/conditions.py only speckles and 5 photons do as much.
	 */
	static final double MOSTLY = 0.5;

	/**
	 * [strands] Noise up to this speaks against no contour. Why: fits hold at a signal-to-noise
	 * ratio of two.
	 */
	static final double HARMLESS_NOISE = 0.5;

	/** [strands] So much more is as bad as it gets. Why: at 0.65 hardly any contour is right. */
	static final double DROWNING_NOISE = 0.15;

	/**
	 * [hypotheses] So many are carried from frame to frame. Why: a knot leaves two or three courses
	 * open; more cost time and find nothing.
	 */
	static final int HYPOTHESES = 3;

	/**
	 * [contours] So many other contours of a frame are kept for a person to choose from. Why: the
	 * right one is among them or must be drawn.
	 */
	static final int ALTERNATIVES = 4;

	/**
	 * [share] Where more of the contour is in the dark, there is no filament. Why: a filament that
	 * is half covered or out of focus still shows half of itself.
	 */
	static final double LOST_DARK = 0.6;

	/**
	 * [share] ... and where more than this is, no contour can be trusted. Why: a third of a contour
	 * without light is a guess.
	 */
	static final double UNRESOLVED_DARK = 0.3;

	/**
	 * [share] The width of a frame is this quantile of its lines' widths. Why: where strands lie
	 * side by side both together are measured, and a low quantile is that of one.
	 */
	static final double FOCUS_QUANTILE = 0.3;

	/**
	 * [px] Fewer pixels of skeleton say nothing of the width. Why: a median of fewer is as noisy as
	 * the pixels.
	 */
	static final int FOCUS_PIXELS = 20;

	/**
	 * [frames] So many frames are taken together when it is asked whether the width changes. Why:
	 * focus wanders over more, noise does not.
	 */
	static final int FOCUS_STEADY = 5;

	/**
	 * [frames] A frame has the median width of so many. Why: one frame may be covered by another
	 * filament.
	 */
	static final int FOCUS_SMOOTH = 3;

	/**
	 * [ratio] The focus wanders if the widest tenth of the frames exceeds the narrowest by this.
	 * Why: widths of a movie in focus agree to some percent.
	 */
	static final double FOCUS_CHANGE = 1.3;

	/**
	 * [share] What is seen clearly for so many of the frames tells which end comes first. Why: less
	 * may be a pause.
	 */
	static final double ENDS_ENOUGH = 0.25;

	/** [frames] ... and for so many. Why: a beat takes as long. */
	static final int ENDS_FEWEST = 10;

	/**
	 * [frames] So many frames in a row that are not clear do not interrupt what is seen. Why: a
	 * crossing takes one or two.
	 */
	static final int ENDS_GAP = 2;

	/**
	 * [px] An end that stays this near to its place, at the median, does not go far. Why: a clamp
	 * on a drifting stage does so.
	 */
	static final double ROAMS = 8;

	/**
	 * [share] A clamped end moves by less than this part of what the other end moves. Why: ends of
	 * a free one move by about as much.
	 */
	static final double HELD_SHARE = 0.4;

	/**
	 * [px] ... and by less than this from frame to frame. Why: fits of an end agree to a third of
	 * that.
	 */
	static final double HELD_STILL = 0.7;

	/**
	 * [px] A clamped end stays this near to its place, at the median. Why: skeletons end within two
	 * pixels, and fields drift.
	 */
	static final double HELD_PLACE = 4;

	/**
	 * [share] ... or, if all drifts, nearer than this part of what the other end does. Why: the
	 * other end beats beside the drift.
	 */
	static final double HELD_PLACE_SHARE = 0.5;

	/**
	 * [share] ... or, however much noise moves it, if it stays nearer to its place than this part of
	 * what the other end does. Why: the two ends of a glider go equally far.
	 */
	static final double HELD_STAYS = 0.1;

	/**
	 * [px] Motion is looked at over so many frames that a filament slides this far. Why: nearer,
	 * noise across the track is as large.
	 */
	static final double GLIDES_FAR = 5;

	/**
	 * [share] What glides comes off its track by less than this part of what it slides. Why: one
	 * that is carried aside does so by all of it.
	 */
	static final double OFF_TRACK = 0.15;

	/**
	 * [ratio] Both ends move alike if neither moves so much less and more smoothly. Why: noise
	 * makes five percent.
	 */
	static final double ENDS_ALIKE = 0.95;

	/**
	 * [ratio] ... and which one comes first is in doubt if neither moves so much less and more
	 * smoothly. Why: of ten carried filaments two of five above this were turned round, and none
	 * below.
	 */
	static final double ENDS_DOUBT = 0.6;

	/**
	 * [px] So much skeleton may be left out by the trail of an open frame. Why: a spur is as long.
	 */
	static final double OPEN_LEFT_OUT = 6;

	/** [px] ... and so much walked twice. Why: skeletons meet in a pixel. */
	static final double OPEN_TWICE = 1;

	/**
	 * [share] Of a crossed trail so much of its length may be walked twice. Why: strands that lie
	 * on each other for longer hide the length.
	 */
	static final double CROSSED_TWICE = 0.25;

	/**
	 * [share] ... if no more line than this part of its length is seen but not drawn, or drawn but
	 * not seen. Why: whichever way it goes at a crossing, its length is then right.
	 */
	static final double CROSSED_UNEXPLAINED = 0.03;

	/**
	 * [share] A fit whose length differs more from its trail's has gone astray. Why: skeletons are
	 * right to some percent.
	 */
	static final double OPEN_ASTRAY = 0.5;

	/**
	 * [frames] Without an open frame in so many, crossed ones are taken. Why: lengths between open
	 * ones are interpolated over less.
	 */
	static final int OPEN_LONG = 8;

	/**
	 * [share] A crossed frame says something new if its length differs so much: a break. Why:
	 * errors of crossed frames are smaller.
	 */
	static final double OPEN_BROKEN = 0.2;

	/**
	 * [share] A fit that runs in the dark for a larger part is none. Why: half of what cannot be
	 * trusted.
	 */
	static final double OPEN_DARK = 0.15;

	/**
	 * [line widths] Parts of a filament are two strands if at least so much of it lies between
	 * them. Why: within a bend it is near itself, too.
	 */
	static final double STRANDS_APART = 4;

	/**
	 * [ratio] Two strands from one contact to the next are equally long to this. Why: they run side
	 * by side, or else the length would not allow to exchange them.
	 */
	static final double STRANDS_ALIKE = 0.15;

	/**
	 * [line widths] Strands that come no farther apart than this are one. Why: which is which is
	 * not seen.
	 */
	static final double STRANDS_SEEN = 0.5;

	/** [line widths] A start that is so near to a fit is no other one. Why: it ends in that fit. */
	static final double STRANDS_SAME = 0.25;

	/**
	 * [line widths] Strands that come farther apart than this are not exchanged. Why: they are
	 * segments of their own, and the graph proposes both ways.
	 */
	static final double STRANDS_NEAR = 5;

	/** [px] The corner at an exchange is smoothed by this. Why: chains do not bend by an angle. */
	static final double STRANDS_SMOOTH = 2;

	/** [contours] So many exchanges are tried in a frame. Why: most have one or two. */
	static final int EXCHANGES = 6;

	/**
	 * [rounds] So often strands are exchanged, each time from the likely contours of then. Why: of
	 * contours with two places to exchange at there are four.
	 */
	static final int EXCHANGE_ROUNDS = 2;

	/**
	 * [price] Contours of a frame are out of the question if without a price of changing course no
	 * movie with them is cheaper than this. Why: twice what one frame does not make up for.
	 */
	static final double COURSE_HOPELESS = 24;

	/**
	 * [px] Usual change of velocity from frame to frame is at least this. Why: so much fits of a
	 * filament that lies still make of noise.
	 */
	static final double LEAST_CHANGE = 0.2;

	/**
	 * [price] Contours that run along the same lines in another order cost the same if their movies
	 * differ by less than about this. Why: what motion costs is less sure than light.
	 */
	static final double EXCHANGED_TIE = 1;

	/**
	 * [strands²] Another order of the same lines explains a frame better if it is so much cheaper
	 * there. Why: light and bending of fits that were chosen rightly are hardly ever dearer by more.
	 */
	static final double EXCHANGED_BETTER = 0.4;

	/**
	 * [share of the frames] ... and the order is a guess in a row of frames if so many are. Why: in noise
	 * some of a long row are by chance.
	 */
	static final double EXCHANGED_OFTEN = 0.25;

	/**
	 * [share of the frames] ... or if in more of a row another order is cheaper by whatever little. Why:
	 * light is the same for both by chance in half of the frames, and motion alone does not tell.
	 */
	static final double EXCHANGED_MOSTLY = 0.5;

	/**
	 * [line widths] ... and they differ if their points at equal arc length lie so far apart. Why:
	 * strands of a wide line are told apart by less than its width.
	 */
	static final double EXCHANGED_APART = 0.6;

	/**
	 * [line widths] ... while each lies so near to the other. Why: where strands cross or touch,
	 * fits stray by this.
	 */
	static final double EXCHANGED_ALONG = 0.4;

	private TrackTuning() {
	}
}
