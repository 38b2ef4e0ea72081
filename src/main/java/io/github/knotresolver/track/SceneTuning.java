package io.github.knotresolver.track;

/**
 * The numbers by which several filaments are told apart and followed together. Brightness is in
 * strands: 1 is that of a single one; prices are in strands squared, as the energy of a fit.
 * {@code scripts/ablation} measures what halving and doubling each does.
 */
final class SceneTuning {

	/**
	 * [px] Contours nearer than this touch. Why: a line is about that wide, and their light runs
	 * into each other.
	 */
	static final double TOUCH = 5;

	/**
	 * [px] Light that is not explained around one filament makes others doubtful that run so near.
	 * Why: what two that touch have exchanged lies up to twice as far apart.
	 */
	static final double BESIDE = 10;

	/**
	 * [px] Two passes agree in a frame if their curves are this near on average. Why: less than a
	 * line's width; fits of one filament agree to a tenth.
	 */
	static final double SAME_CURVE = 3;

	/**
	 * [px] Two curves differ visibly whose points are somewhere farther from each other. Why: a
	 * line is about that wide.
	 */
	static final double VISIBLY_FAR = 5;

	/**
	 * [share] Filaments whose lengths differ by more than this, and the next, are not the same.
	 * Why: lengths of clear frames agree to less.
	 */
	static final double SAME_LENGTH_SHARE = 0.02;

	/** [px] ... of which this is added, for short ones. Why: an end is known to a pixel. */
	static final double SAME_LENGTH = 1;

	/**
	 * [frames] So many frames must agree for two passes to have the same filament. Why: two
	 * filaments may lie on each other in one or two.
	 */
	static final int AGREEING = 3;

	/**
	 * [px] A chain that moves less in a sweep has found its place. Why: the others hardly feel it.
	 */
	static final double SWEEP_STILL = 0.2;

	/**
	 * [px] A chain whose links have become shorter is divided anew. Why: half the usual link: it
	 * bends into noise.
	 */
	static final double SHORTEST_LINK = 1.5;

	/** [px] ... or longer. Why: half more than the usual link: it cuts corners. */
	static final double LONGEST_LINK = 4.5;

	/**
	 * [px] A chain does not get shorter. Why: it could not be told from a spot, and would vanish
	 * from the fit.
	 */
	static final double SHORTEST_CHAIN = 4;

	/**
	 * [strands²] A gap of this price gives a confidence of 63 %. Why: the noise of a fit's energy.
	 */
	static final double SCENE_GAP = 2;

	/**
	 * [strands²] Unexplained light around a contour that says nothing. Why: the model of the line
	 * leaves as much.
	 */
	static final double HARMLESS_LIGHT = 0.25;

	/**
	 * [strands²] So much more leaves a third of the confidence. Why: it is the light of some pixels
	 * of a strand.
	 */
	static final double LIGHT_SCALE = 1;

	/** [usual motion] Motion up to this says nothing. Why: beating filaments whip. */
	static final double USUAL_HASTE = 3;

	/**
	 * [usual motion] ... and from this on leaves least. Why: only an exchange of filaments is as
	 * fast.
	 */
	static final double HOPELESS_HASTE = 10;

	/** [share] ... which is this. Why: motion alone does not rule a contour out. */
	static final double LEAST_OF_HASTE = 0.05;

	/**
	 * [strands²] Where light does not add up: if so much more was unexplained with a contour slid
	 * along itself so far that it shows, its frame gives a confidence of 63 %. Why: one end in the
	 * open shows four times as much, and what the line's model leaves is a quarter.
	 */
	static final double HIDDEN_LIGHT = 1;

	/**
	 * [probability] ... and at least this. Why: what is hidden alone does not rule a contour out;
	 * most filaments are where they were heading.
	 */
	static final double LEAST_OF_HIDDEN = 0.4;

	/**
	 * [share] A filament may be unclear in so many frames, and no frame of it is doubtful for that.
	 * Why: crossings take as many.
	 */
	static final double SELDOM_UNCLEAR = 0.2;

	/**
	 * [strands] Light below this is hardly any. Why: a third of a strand: noise and halos stay
	 * below.
	 */
	static final double DARK_LIGHT = 0.35;

	/**
	 * [frames] A contour is no surer than those of so many frames before and after it. Why:
	 * identities are exchanged for longer than one frame.
	 */
	static final int LIKE_NEIGHBOURS = 5;

	/**
	 * [strands²] Price of a filament in a frame. Why: light of some pixels is debris, not a
	 * filament.
	 */
	static final double PER_FILAMENT = 3;

	/**
	 * [strands²] So much unexplained light around a place is no noise. Why: two pixels at the most
	 * that one counts.
	 */
	static final double UNCLEAR_LIGHT = 0.5;

	/**
	 * [px] A filament that ends at a place that a person shows does so within this. Why: ends drift
	 * while the movie runs.
	 */
	static final double PLACE_NEAR = 12;

	/**
	 * [share] A filament is known that is clear in so many of the frames. Why: a mistake is not
	 * followed for half of a movie with all light explained.
	 */
	static final double KNOWN_CLEAR = 0.5;

	/** [share] Clear in so many: beyond doubt. Why: a crossing may hide the rest. */
	static final double ALWAYS_CLEAR = 0.98;

	/** [px] Chains lie on each other where they are this near. Why: less than a line's width. */
	static final double OVERLAP_NEAR = 3;

	/**
	 * [share] ... and are one if they are for this part of either. Why: filaments that cross share
	 * less.
	 */
	static final double OVERLAP = 0.5;

	/**
	 * [share] A filament that is unclear in more of the frames is followed again. Why: one frame in
	 * fifty may be noise.
	 */
	static final double SOME_UNCLEAR = 0.02;

	/**
	 * [share] If less of the filaments, by length, is clear, none is followed again. Why: of random
	 * movies with up to 9 % clear none became visibly better, in up to three times the time of all
	 * else; movies that did had 42 % and more.
	 */
	static final double HOPELESS_CLEAR = 0.3;

	/**
	 * [rounds] So often all that are unclear are followed again. Why: what one round mends may
	 * clear another filament; a third round finds nothing.
	 */
	static final int REFINE_ROUNDS = 2;

	/**
	 * [px] What moves less from frame to frame, at the median, lies still. Why: debris does, and
	 * fits scatter by less.
	 */
	static final double REFINE_STILL = 0.5;

	/**
	 * [filaments] A filament that winds up is not taken for more than so many. Why: its strands
	 * meet, so that there are no more ends.
	 */
	static final int MOST_PIECES = 4;

	/**
	 * [strands] Where known filaments shine more, the mask of the rest is made anew. Why: below,
	 * what they leave is noise.
	 */
	static final double KNOWN_SHINES = 0.1;

	/**
	 * [strands] There a pixel belongs to the rest if so much light is left around it. Why: near
	 * half of a strand.
	 */
	static final double REST_LEFT = 0.4;

	/**
	 * [px] A filament of the next frame lies within this. Why: faster ones are not followed from a
	 * seed.
	 */
	static final double SEED_NEAR = 8;

	/** [px] ... and is as long within this. Why: its ends are known to a pixel or two. */
	static final double SEED_LENGTH = 2.5;

	/** [share] ... or, if it is long, this. Why: fits of crossed frames agree to that. */
	static final double SEED_LENGTH_SHARE = 0.03;

	/**
	 * [share] What a chain that the frames beside it do not have takes from a seed's worth. Why:
	 * fifty of them make a seed worthless.
	 */
	static final double SEED_DOUBT = 0.02;

	/** [points] Curves are compared at so many points. Why: closer ones move together. */
	static final int SEED_POINTS = 24;

	/**
	 * [strands²] A filament must explain more light than this. Why: some pixels more than a bright
	 * spot has.
	 */
	static final double FILAMENT_LIGHT = 12;

	/** [px] ... and be longer. Why: shorter ones have no direction. */
	static final double FILAMENT_SHORTEST = 8;

	/** [px] Corners of a trail are smoothed by this. Why: pixels make a staircase of a width. */
	static final double SEED_SMOOTH = 2;

	/**
	 * [px] A skeleton ends so much before the light does. Why: half a usual width, less what
	 * thinning leaves.
	 */
	static final double SEED_HIDDEN = 1.5;

	/**
	 * [rad] A turn by more than this is two ends that touch. Why: filaments do not bend by a right
	 * angle within a few widths.
	 */
	static final double SEED_CORNER = 1.75;

	/** [px] ... within twice this. Why: less is a staircase, more is a bend. */
	static final int CORNER_REACH = 8;

	/**
	 * [sweeps] So often the chains of trails are fitted at first. Why: they begin a pixel or two
	 * off.
	 */
	static final int FIRST_SWEEPS = 3;

	/** [sweeps] ... and after each change. Why: only what changed moves. */
	static final int SEED_SWEEPS = 2;

	/**
	 * [rounds] So often what is left unexplained becomes chains. Why: what two rounds leave is no
	 * line.
	 */
	static final int SEED_ROUNDS = 2;

	/**
	 * [weight] Price of motion against unexplained light. Why: a jump must outweigh the light of a
	 * pixel or two.
	 */
	static final double SETTLE_MOTION = 3;

	/**
	 * [strands²] Price of going from one pass to another. Why: as much as a gap that gives 63 % of
	 * confidence.
	 */
	static final double SETTLE_CHANGE = 2;

	/**
	 * [weight] Price of bending against that of the fit. Why: the light has had its say in the fit;
	 * bending breaks ties.
	 */
	static final double SETTLE_BENDING = 0.3;

	/** [px] The usual motion is at least this. Why: fits are no better. */
	static final double SETTLE_LEAST = 0.5;

	/**
	 * [strands] Light that is missing or too much by more than this is no noise. Why: the model of
	 * the line is off by less.
	 */
	static final double MISMATCH = 0.3;

	/**
	 * [noise sigma] ... and by more than this. Why: it is exceeded by three pixels in a hundred.
	 */
	static final double MISMATCH_NOISE = 2.2;

	/**
	 * [frames] For so many frames on end a chain is mended in each. Why: what ten frames do not
	 * mend is debris or another filament.
	 */
	static final int PATIENCE = 10;

	/** [frames] ... then in every so many. Why: it may come free later. */
	static final int SELDOM_MENDED = 5;

	/**
	 * [share] Where more of a contour is in the dark, there is no filament. Why: as of a single
	 * filament.
	 */
	static final double SCENE_LOST = 0.6;

	/**
	 * [share] ... and where more than this is, no contour can be trusted. Why: as of a single
	 * filament.
	 */
	static final double SCENE_UNRESOLVED = 0.3;

	/**
	 * [probability] A contour that is less sure is none. Why: nineteen in twenty would be wrong.
	 */
	static final double SCENE_HOPELESS = 0.05;

	/**
	 * [share] A filament of which less is inside the picture is not in view. Why: what a quarter
	 * shows could be another one.
	 */
	static final double IN_VIEW = 0.25;

	/**
	 * [line widths] What is shorter is no filament. Why: it is a blurred spot: as long as wide, and
	 * blurred at both ends.
	 */
	static final double SCENE_SPECK = 16;

	/** [line sigma] What is shorter is a spot. Why: one is no longer than two line widths. */
	static final double SPECK_LINE = 5;

	/**
	 * [frames, share] A longer one that is beside a filament in more of them may be a part of it. Why:
	 * what passes by is there for some frames.
	 */
	static final double STAYS_BESIDE = 0.5;

	/**
	 * [probability] A free filament that is less sure on average may be a clamped one that winds
	 * up. Why: free ones that are resolved are surer.
	 */
	static final double CREDIBLE = 0.8;

	/**
	 * [price a rad² px] Memory of the predicted shape, nearly rigid. Why: a filament first finds
	 * its place, then its shape.
	 */
	static final double RIGID = 3;

	/** [price a rad² px] ... then loose. Why: only where there is no light does it count. */
	static final double LOOSE = 0.5;

	/**
	 * [iterations] A fit with free ends takes so many steps at most. Why: its ends creep, and
	 * sweeps go on from there.
	 */
	static final int FREE_ITERATIONS = 12;

	/** [iterations] ... one that is nearly rigid so many. Why: it is a start only. */
	static final int FEW_ITERATIONS = 6;

	/** [iterations] ... and one that is loose so many. Why: it settles in ten. */
	static final int LOOSE_ITERATIONS = 25;

	/**
	 * [share] A fit ends when its energy falls by less. Why: nodes move by less than a hundredth of
	 * a pixel.
	 */
	static final double SCENE_TOLERANCE = 4e-4;

	/** [share] ... a first one when by less than this. Why: it is fitted again. */
	static final double SCENE_ROUGH = 2e-3;

	/**
	 * [share] ... and one that decides between two courses when by less than this. Why: filaments
	 * that lie side by side creep towards their places.
	 */
	static final double SCENE_EXACT = 2e-5;

	/**
	 * [ratio] Of seeds, stiffness is so much higher at first. Why: corners of trails are no bends.
	 */
	static final double STIFFER = 4;

	/** [px] Nodes nearer than this touch. Why: a line is about that wide. */
	static final double SWAP_TOUCH = 5;

	/**
	 * [px] A part may miss so much of a filament's length. Why: tails are grown again from there.
	 */
	static final double SWAP_LENGTH = 10;

	/** [px] A filament's start does not jump farther. Why: it is the same end. */
	static final double SWAP_JUMP = 25;

	/**
	 * [strands²] An exchange is kept if it is cheaper by this. Why: the noise of a fit's energy.
	 */
	static final double SWAP_BETTER = 2;

	/** [px] The corner at an exchange is smoothed by this. Why: chains do not bend by an angle. */
	static final double SWAP_SMOOTH = 1.5;

	/** [nodes] Exchanged filaments have at least so many. Why: fewer have no shape. */
	static final int SWAP_NODES = 5;

	/**
	 * [px] Around an end it is looked so far. Why: three widths: the end may have turned within.
	 */
	static final int TIP_NEAR = 9;

	/**
	 * [strands²] What growing an end anew must gain to be fitted. Why: the noise of a fit's energy.
	 */
	static final double TIP_PROMISING = 2;

	/** [strands²] ... and to be kept. Why: the fit gains from noise as well. */
	static final double TIP_BETTER = 1;

	/**
	 * [share] What a Gaussian of {@code RESIDUE_BLUR} leaves of the noise. Why: its sum of squares.
	 */
	static final double CALMED = 0.35;

	/**
	 * [px] Light that is left is blurred by this before it counts. Why: single pixels are noise.
	 */
	static final double LEFT_BLUR = 1;

	/** [strands] ... and counts from this on. Why: near half of a strand. */
	static final double LEFT_BRIGHT = 0.4;

	/** [px] Fewer pixels are no stretch of a line. Why: two widths in square are a spot. */
	static final int LEFT_PIXELS = 8;

	/**
	 * [px] A stretch this long makes a chain longer. Why: shorter ones are the error of the line's
	 * model.
	 */
	static final double LEFT_EXTENDS = 6;

	/** [px] ... and this long is a chain of its own. Why: shorter ones have no direction. */
	static final double LEFT_OWN = 10;

	/** [px] An end goes on in a stretch this near. Why: where strands cross, they hide as much. */
	static final double LEFT_NEAR = 12;

	/**
	 * [cosine] ... that it points to as well as this. Why: filaments bend by no more over that
	 * distance.
	 */
	static final double LEFT_ALIGNED = 0.8;

	/**
	 * [px] The direction of an end is taken over so many pixels. Why: less is noise, more is a
	 * bend.
	 */
	static final double LEFT_END = 9;

	/**
	 * [frames] In about so many frames lengths are measured. Why: their median is then known to a
	 * fifth of one's error.
	 */
	static final int LENGTH_LOOKS = 24;

	/** [frames] ... and so many must tell. Why: a median of five is not misled by two. */
	static final int LENGTH_FEWEST = 5;

	/**
	 * [px] A length that is farther off is wrong. Why: an end is known to less, over so many
	 * frames.
	 */
	static final double LENGTH_OFF = 0.5;

	/**
	 * [share] ... for a long filament, by more than this. Why: fits of open frames agree to that.
	 */
	static final double LENGTH_OFF_SHARE = 0.005;

	/** [px] A length steps by at least this. Why: less is the error of an end. */
	static final double LENGTH_STEP = 1.2;

	/** [standard deviations] ... and by so many of its scatter. Why: noise does not in a movie. */
	static final double LENGTH_CLEARLY = 4;

	/** [frames] ... with so many lengths on each side. Why: one or two may be wrong. */
	static final int LENGTH_ASIDE = 4;

	/**
	 * [px] Two that were exchanged are tried as they were in the frame before if they are somewhere
	 * farther from that. Why: from nearer a fit gets there by itself.
	 */
	static final double HALVES_OFF = 2;

	/**
	 * [sweeps] Two that were exchanged take turns so often at most. Why: side by side they creep.
	 */
	static final int HALVES_SWEEPS = 8;

	/** [px] ... or until neither moves farther. Why: it tells their lengths to less. */
	static final double HALVES_STILL = 0.1;

	/**
	 * [rounds] So often the lengths of two that were exchanged are measured again. Why: the step of
	 * a length tells it but to a pixel.
	 */
	static final int HALVES_ROUNDS = 1;

	/**
	 * [sweeps] So often chains are fitted when a length is measured. Why: they were fitted before,
	 * and hardly move after the second.
	 */
	static final int LENGTH_SWEEPS = 2;

	/**
	 * [share] The mean over 3 x 3 pixels of a line whose ridge is 1, about. Why: that of a Gaussian
	 * of 1.5 px.
	 */
	static final double MEAN_OF_RIDGE = 0.85;

	/**
	 * [share] Of the brightness along all trails, this quantile is one strand's. Why: crossings and
	 * bundles are brighter, ends dimmer.
	 */
	static final double STRAND_QUANTILE = 0.3;

	/**
	 * [px] The line's width that estimating begins with. Why: half-way between what cameras give;
	 * two rounds later it is forgotten.
	 */
	static final double FIRST_SIGMA = 1.5;

	/** [frames] About so many frames are looked at for open ones. Why: three of them are wanted. */
	static final int LINE_LOOKS = 20;

	/**
	 * [frames] So many frames are enough to learn the line. Why: each has hundreds of pixels along
	 * its filaments.
	 */
	static final int LINE_FRAMES = 3;

	/**
	 * [rounds] How often line and curves are estimated in turns. Why: the line hardly changes after
	 * the second.
	 */
	static final int LINE_ROUNDS = 2;

	/**
	 * [sweeps] So often the curves are fitted in a round. Why: they hardly move after the second.
	 */
	static final int LINE_SWEEPS = 2;

	/**
	 * [points] So many points at the ends of a curve say nothing of its brightness. Why: a junction
	 * shines there.
	 */
	static final int LINE_RIM = 2;

	/** [junctions] Fewer do not tell whether light adds up. Why: some may be two ends that touch. */
	static final int CROSSINGS_FEWEST = 5;

	/**
	 * [share] This quantile of the light at junctions is that of a crossing. Why: at most of them
	 * strands only come near each other, which is as bright as one.
	 */
	static final double CROSSINGS_QUANTILE = 0.9;

	/** [px] A crossing is brightest this near to its junction. Why: a line's width. */
	static final int CROSSING_NEAR = 2;

	/**
	 * [strands] Where crossings are brighter, light adds up. Why: half-way between one strand and
	 * two.
	 */
	static final double CROSSING_DOUBLE = 1.5;

	/** [px] Light of an object reaches so far. Why: two widths of a usual line. */
	static final int LINE_NEAR = 3;

	/**
	 * [passes] At most so many are tried. Why: each takes as long as the movie; later seeds are
	 * worse.
	 */
	static final int MOST_PASSES = 5;

	/**
	 * [passes] ... and after so many, one that leaves hardly any light is enough, also if in a
	 * crowd some filaments are often unclear. Why: the first ones tell what is known; the next
	 * would have to be clearer still.
	 */
	static final int CLEAR_ENOUGH = 3;

	/** [passes] ... and of those so many are settled together. Why: three outvote one. */
	static final int SETTLED_PASSES = 3;

	/**
	 * [strands²] A pass that leaves less, a frame and filament, is right. Why: the model of the
	 * line leaves half of that.
	 */
	static final double CLEAR_PASS = 0.08;

	/**
	 * [share] Less than this part of what a pass leaves unexplained is visibly less. Why: a
	 * filament too many explains some noise.
	 */
	static final double VISIBLY_LESS = 0.8;

	/**
	 * [probability] Confidence of a filament whose length changes. Why: which of its frames are
	 * right is open.
	 */
	static final double LENGTH_DOUBT = 0.5;

	/**
	 * [frames] About so many frames are looked at for seeds, each with its two neighbours. Why:
	 * some of twelve are open in most movies.
	 */
	static final int SEED_LOOKS = 12;

	/**
	 * [parts] Seeds are at least one of so many parts of the movie apart. Why: neighbouring ones
	 * have the same faults.
	 */
	static final int SEED_SPACING = 5;

	/**
	 * [frames] So many frames are looked at again with what is known. Why: each takes as long as
	 * the first look.
	 */
	static final int SEED_AGAIN = 5;

	/**
	 * [share] Where so much of the light is known, there is nothing to look for. Why: noise and
	 * halos are the rest.
	 */
	static final double SEED_ALL = 0.98;

	/**
	 * [share] A seed that is worth less than this part of the best is not followed. Why: where a
	 * third of the light has no chain, a filament is missing.
	 */
	static final double SEED_WORTH = 0.7;

	/**
	 * [share] Once, one of fewer filaments is followed if it is worth this part of the best. Why:
	 * pieces of a filament last as long as it does, so that what explains less may be right.
	 */
	static final double SEED_FEWER = 0.4;

	/**
	 * [worth] A seed that is worth this much needs no help from what is known. Why: nine tenths of
	 * the light are explained by chains that the frames beside it have, too.
	 */
	static final double SEED_SOUND = 0.9;

	/**
	 * [pairs] So many of those that may be each other's halves where a pass began are tried. Why: a
	 * mistake of one crossing makes two filaments unclear, and one or two that they meet.
	 */
	static final int SEED_EXCHANGES = 4;

	/**
	 * [px] Exchanged, both filaments must be as long as they are within this. Why: ends are known
	 * to a pixel or two each.
	 */
	static final double EXCHANGE_LENGTH = 4;

	/**
	 * [strands²] What an exchange may cost before it is fitted. Why: a fit gains no more than that.
	 */
	static final double EXCHANGE_HOPELESS = 60;

	/**
	 * [exchanges] So many of a kind are fitted in a frame. Why: two that lie side by side touch in
	 * one place and cross in another.
	 */
	static final int EXCHANGE_FITTED = 2;

	/**
	 * [share] Pieces of one filament follow each other in more of the frames. Why: two filaments
	 * that move on their own do so by chance only.
	 */
	static final double PIECES_MOST = 0.9;

	/**
	 * [share] ... or touch in so many, and in this part of the frames one goes on as the other ends.
	 * Why: a bend that slides through where they meet is there for a while; what is fixed at one
	 * place with another one hardly ever points along it.
	 */
	static final double PIECES_ALIGNED = 0.5;

	/**
	 * [px] An end stays where two filaments exchange their other ends. Why: fits of an end scatter
	 * by less.
	 */
	static final double END_STAYS = 5;

	/**
	 * [frames] In fewer frames an exchange is not looked at. Why: a single frame does not show an
	 * exchange.
	 */
	static final int EXCHANGE_FEWEST = 2;

	/**
	 * [iterations] ... and one of several hypotheses so many. Why: the best of them is fitted
	 * again.
	 */
	static final int SOME_ITERATIONS = 8;

	/**
	 * [share] A fit of several hypotheses ends when its energy falls by less. Why: between a first
	 * and a last fit.
	 */
	static final double SCENE_FAIR = 1e-3;

	/**
	 * [frames] A filament is followed again from where it is clear in so many frames on end. Why:
	 * fewer may be a chance of crossing filaments.
	 */
	static final int AGAIN_CLEAR = 10;

	/**
	 * [frames] Where it becomes unclear it may have been wrong so many frames before. Why: a wrong
	 * course at a crossing explains the light for some frames.
	 */
	static final int AGAIN_BACK = 4;

	/** [px] Its links are so long. Why: it can turn around within a line's width. */
	static final double AGAIN_LINK = 1.5;

	/**
	 * [px] What slides less from frame to frame may turn at either end. Why: errors of a fit are as
	 * large.
	 */
	static final double PURSUIT_SLOW = 0.5;

	/**
	 * [strands²] An end that is grown anew is fitted if it is not dearer by more than this. Why: a
	 * fit gains about as much.
	 */
	static final double PURSUIT_PROMISING = 6;

	/**
	 * [ends] So many of them are fitted. Why: at a crossing there are three ways to go, each with a
	 * bend or without.
	 */
	static final int PURSUIT_FITTED = 6;

	/** [hypotheses] At most so many are carried on. Why: each costs as much as a frame. */
	static final int PURSUIT_MOST = 24;

	/**
	 * [strands²] ... none that is dearer by more than this. Why: the light of several frames does
	 * not make up for it.
	 */
	static final double PURSUIT_MARGIN = 12;

	/**
	 * [px] Hypotheses that are nowhere farther from each other are one. Why: less than a line's
	 * width.
	 */
	static final double PURSUIT_SAME = 1.5;

	/**
	 * [rounds] So often, there and back, each frame is tried as those before and after it say. Why:
	 * what later frames tell comes from farther away in each round; a fourth finds nothing.
	 */
	static final int BOTH_ROUNDS = 3;

	/** [strands²] ... and what is cheaper by this is kept. Why: the noise of a fit's energy. */
	static final double BOTH_BETTER = 0.1;

	/**
	 * [share] So much of its bending a track pays for in each frame. Why: it lies in ten frames or
	 * more.
	 */
	static final double BENT_ONCE = 0.1;

	/**
	 * [px] A piece before a held end that buckles is about so long. Why: in actin's smallest rings
	 * half a turn is 8 px, and what is longer than 24 buckles in more than one place.
	 */
	static final double HELD_PIECE = 14;

	/** [factor] It stands out from its chord at most so much farther. Why: that of two frames' push. */
	static final double HELD_STRETCH = 8;

	/**
	 * [share] An end that moves by less than this part of what the filament slides is held. Why:
	 * half-way between an end that stays and one that slides along.
	 */
	static final double HELD_SHARE = 0.5;

	/** [iterations] How far, is found by halving. Why: to a hundredth of a pixel. */
	static final int HELD_HALVINGS = 14;

	/** [shapes] So many shapes with a held end are fitted. Why: to either side. */
	static final int HELD_FITTED = 2;

	/** [frames] Fewer frames do not tell what lies still. Why: a filament may rest for as long. */
	static final int STILL_LEAST = 10;

	/** [frames] So many tell it. Why: in a tenth of them three are dark. */
	static final int STILL_LOOKS = 32;

	/**
	 * [frames] Ends that lie still are looked for in so many. Why: in one of them an end may be
	 * hidden.
	 */
	static final int STILL_END_LOOKS = 5;

	/**
	 * [px] An end lies still if one is seen so near to it. Why: skeletons end up to half a line's
	 * width too early.
	 */
	static final double STILL_END_NEAR = 5;

	/** [share] ... in so many of the frames. Why: others lie on it for a while. */
	static final double STILL_END_SEEN = 0.75;

	/**
	 * [strands² px] Bending of a line that lies still costs so much. Why: it hardly bends within
	 * the 30 px in which a filament runs into it.
	 */
	static final double STILL_STIFFNESS = 100;

	/** [sweeps] ... in so many rounds with all others. Why: after two, none moves by a tenth. */
	static final int STILL_SWEEPS = 3;

	/** [strands] What is brighter lies in a line. Why: its flanks are half as bright. */
	static final double STILL_BRIGHT = 0.5;

	/**
	 * [share] A line lies still as long as its brightness is the same within this. Why: noise is
	 * less, and a line that moves by its width leaves less than half.
	 */
	static final double STILL_CHANGES = 0.3;

	/** [share] ... which must be so in so many of the frames. Why: others lie along it for a while. */
	static final double STILL_THERE = 0.9;

	/**
	 * [strands] What lies over a line adds at least so much light somewhere. Why: half a strand: it
	 * hardly lies on the very middle.
	 */
	static final double STILL_PASSED = 0.5;

	/** [noise sigma] ... and so much. Why: in the mean of nine pixels, that is six sigma. */
	static final double STILL_NOISES = 2;

	/**
	 * [parts] A seed is followed for one of so many parts of the movie, both ways, before it is
	 * believed. Why: filaments that lie end to end part by some line widths in that time.
	 */
	static final int MEND_PART = 10;
	/** [frames] ... and for at least so many. Why: one frame may be noise. */
	static final int MEND_LEAST = 3;
	/**
	 * [rounds] So often a seed is mended. Why: a trail of three filaments takes two rounds, and what
	 * was mended may leave light around another one.
	 */
	static final int MEND_ROUNDS = 4;
	/**
	 * [filaments] A seed of more is not mended if light is left around all of them. Why: where some are
	 * right, their neighbours can be; trails through noise become more with every cut.
	 */
	static final int MEND_HANDFUL = 4;
	/**
	 * [strands²] Something else is kept if it costs less by this in a frame, the price of a filament
	 * more included. Why: light around one place.
	 */
	static final double MEND_BETTER = 0.5;
	/**
	 * [strands²] ... and given up if it costs so much more in the frames that were looked at. Why:
	 * what is right is as cheap as long as both lie in one place.
	 */
	static final double MEND_HOPELESS = 10;
	/**
	 * [rad] A filament may be two where it turns by more than this within twice {@code
	 * CORNER_REACH}. Why: twice what a stiff one turns there; that it turns sharply proves nothing,
	 * that both parts can be followed does.
	 */
	static final double MEND_CORNER = 0.35;
	/** [places] ... and is cut at so many of them. Why: a trail of three filaments has two. */
	static final int MEND_CUTS = 2;
	/**
	 * [exchanges] So many exchanges of two filaments are tried. Why: they touch in a place in two
	 * ways.
	 */
	static final int MEND_EXCHANGES = 2;

	private SceneTuning() {
	}
}
