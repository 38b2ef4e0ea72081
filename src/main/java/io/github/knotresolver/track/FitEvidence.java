package io.github.knotresolver.track;

import java.util.Locale;

/**
 * What can be seen of a chosen contour after the fact, each as a figure that is 0 if nothing
 * speaks against it and grows with what does.
 *
 * @param rival how cheap a movie with a visibly different contour in this frame is: 1 if it
 *          costs the same, falling to 0
 * @param misfit logarithm of how much worse than usual the contour explains the frame
 * @param pattern logarithm of the residual around the contour in units of the noise
 * @param dark share of the contour that runs in the dark
 * @param unexplained line that is seen near the contour but not on it, as a share of its length
 * @param invented line that is drawn but not seen, as a share of its length
 * @param beyond brightness of the light beyond the tip or before the fixed end, relative to
 *          the end's; 0 if it is not sure
 * @param missing how much light is missing at the tip: 0 if it ends in the light, 1 if the
 *          last piece is dark
 * @param uncovered skeleton of the objects that it touches but does not run along, as a share
 *          of its length
 * @param jump logarithm of how much farther than usual it moved from or to a neighbour in time
 * @param faint how strong the noise of a pixel is beside a strand, beyond what is harmless
 * @param folded how far the contour turns back on itself within the width of a line
 * @param elsewhere in how many of the movie's frames contours do not end where their light does; as
 *          bad as can be if in most they leave out something
 * @param worse how much stronger the pattern is than in most of the movie's frames, where it is
 *          beyond noise
 */
public record FitEvidence(double rival, double misfit, double pattern, double dark,
	double unexplained, double invented, double beyond, double missing, double uncovered,
	double jump, double faint, double folded, double elsewhere, double worse) {

	/** Each figure is cut off here: more of it makes nothing worse. */
	private static final double[] MOST = {1, 2, 1, 0.5, 0.25, 0.5, 1, 1, 1, 3, 1, 1, 1, 1};

	/** Names of the figures, in order. */
	public static final String NAMES = "rival,misfit,pattern,dark,unexplained,invented,beyond,missing,uncovered,jump,faint,folded,elsewhere,worse";

	/** The figures from this one on are no more than doubts. */
	static final int DOUBTS = 11;

	/** A pixel's noise in strands' brightnesses as a figure. */
	static double faint(final double noise) {
		return Math.max(0, (noise - TrackTuning.HARMLESS_NOISE) / TrackTuning.DROWNING_NOISE);
	}

	/** The sharpest turn of a contour within a line's width, in radians, as a figure. */
	static double folded(final double turn) {
		return Math.max(0, (turn - TrackTuning.HARMLESS_TURN)
			/ (TrackTuning.HOPELESS_TURN - TrackTuning.HARMLESS_TURN));
	}

	/**
	 * How much stronger the pattern of what is left is than usual, as a figure.
	 *
	 * @param pattern logarithm of the residual around a contour in units of the noise
	 * @param usual the same in the middle of the movie's frames
	 */
	static double worse(final double pattern, final double usual) {
		return Math.max(0,
			(pattern - Math.max(TrackTuning.PLAIN_PATTERN, usual + TrackTuning.USUAL_PATTERN))
				/ TrackTuning.UNUSUAL_PATTERN);
	}

	private static final String[] WORDS = {"a different contour explains the movie nearly as well",
		"the contour explains this frame worse than others are explained",
		"light around the contour differs from what is expected, beyond noise",
		"parts of the contour run in the dark",
		"there is a line near the contour that is not on it",
		"the contour crosses or runs along places that are darker than expected",
		"light goes on beyond an end of the contour", "the contour's tip is in the dark",
		"the contour leaves out parts of the object that it touches",
		"the contour moved much farther than usual since the frame before or to the next",
		"noise is so strong that a wrong contour may look right",
		"the contour turns back within the width of a line, as it does to explain a spot",
		"in other frames the contour does not end where its light does or leaves out a line, so its length, an end or its course is not right",
		"light around the contour differs more from what is expected than in other frames"};

	/** @return the figures in the order of their names, none negative, none above what matters */
	public double[] figures() {
		final double[] figures = {rival, misfit, pattern, dark, unexplained, invented, beyond,
			missing, uncovered, jump, faint, folded, elsewhere, worse};
		for (int i = 0; i < figures.length; i++)
			figures[i] = Double.isNaN(figures[i])
				? MOST[i]
				: Math.max(0, Math.min(MOST[i], figures[i]));
		return figures;
	}

	/** A figure in words, as the reason of a low confidence. */
	static String words(final int figure) {
		return WORDS[figure];
	}

	@Override
	public String toString() {
		final StringBuilder text = new StringBuilder();
		for (final double figure : figures())
			text.append(text.length() == 0 ? "" : ",")
				.append(String.format(Locale.ROOT, "%.5f", figure));
		return text.toString();
	}
}
