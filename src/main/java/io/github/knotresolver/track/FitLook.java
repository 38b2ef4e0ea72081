package io.github.knotresolver.track;

import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.EndLight;
import io.github.knotresolver.fit.FitQuality;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Residue;

/**
 * A look at a contour in its frame, for itself.
 *
 * @param quality how well it agrees with the frame
 * @param residue what it leaves unexplained
 * @param beyond brightness of the light beyond an end, relative to the end's; 0 if not sure
 * @param missing share of the light that is missing at the tip, 0..1
 * @param uncovered skeleton of the objects that it touches but does not run along, as a share
 *          of its length
 */
record FitLook(FitQuality quality, Residue residue, double beyond, double missing,
	double uncovered) {

	/** O(pixels). */
	static FitLook at(final FrameView frame, final NormalizedFrame light, final LineModel model,
		final Chain chain) {
		final EndLight ends = new EndLight(light, model, light.noise());
		final EndLight.Piece last = ends.beforeTip(chain);
		return new FitLook(FitQuality.of(light, model, chain), Residue.of(light, model, chain),
			ends.beyond(chain), last.isSeen() ? Math.max(0, Math.min(1, 1 - last.brightness())) : 0,
			Uncovered.share(frame.graph(), chain.contour()));
	}

	/** Whether no light goes on beyond an end, and none is missing at the tip. */
	boolean endsWithLight() {
		return Math.max(beyond, missing) < TrackTuning.ENDS_WITH_LIGHT;
	}

	/**
	 * In how many frames contours do not end where their light does, as a figure: the length or
	 * an end is not right then, in frames in which that is hidden, too.
	 *
	 * @param looks one for each frame that has one
	 * @return 0 if nearly all do
	 */
	static double elsewhere(final List<FitLook> looks) {
		final long off = looks.stream().filter(l -> !l.endsWithLight()).count();
		final double share = (double) off / Math.max(1, looks.size());
		return Math.max(0,
			(share - TrackTuning.SELDOM_ENDS) / (TrackTuning.OFTEN_ENDS - TrackTuning.SELDOM_ENDS));
	}

	/** Whether hardly any line or skeleton near the contour is left out. */
	private boolean explainsItsLines() {
		return Math.max(residue.unexplained(), uncovered) <= TrackTuning.LEFT_OUT;
	}

	/**
	 * Whether contours leave out something in most frames, be it a line near them or light at an end,
	 * as a figure: one length, or one way through the movie, is not right then in any frame.
	 *
	 * @param looks one for each frame that has one
	 * @return 1 if so, otherwise 0
	 */
	static double leavesOut(final List<FitLook> looks) {
		return looks.stream().filter(l -> !l.endsWithLight() || !l.explainsItsLines())
			.count() > TrackTuning.MOSTLY * looks.size() ? 1 : 0;
	}
}
