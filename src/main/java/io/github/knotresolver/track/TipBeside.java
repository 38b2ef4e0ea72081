package io.github.knotresolver.track;

import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Observation;

/**
 * Whether a wide filament's tip runs along another part of it, within a line's width. What is seen
 * there is one line, somewhat wider than usual: how far apart the two are, and which one is on which
 * side, shows in noise only to half of the width.
 *
 * @param width of a line in pixels, half way down
 */
record TipBeside(double width) {

	private static final String WHY = "Doubtful: the tip of a wide line runs along another part of it within the width of the line, so where it is shows to half of the width only.";

	/** Points at which a tip is looked at. */
	private static final int SAMPLES = 10;

	/**
	 * @param sigma of the line in pixels
	 * @return for lines as wide
	 */
	static TipBeside ofLine(final double sigma) {
		return new TipBeside(LineAppearance.FULL_WIDTH * sigma);
	}

	/**
	 * Takes the confidence off where the tip is beside the filament. O(frames * length).
	 *
	 * @param frames of one filament, in order of time
	 * @param noise of a pixel beside the brightness of the tip
	 * @param wrong how far a contour that is right may be off, in the same pixels
	 * @return the same contours, none of which is believed if its tip may be off by that
	 */
	List<Observation> doubted(final List<Observation> frames, final double noise,
		final double wrong) {
		return noise < TrackTuning.BESIDE_NOISE || width < 2 * wrong * TrackTuning.BESIDE_WRONG
			? frames
			: frames.stream()
				.map(o -> o.contour().filter(this::isBeside).isPresent()
					? o.doubted(TrackTuning.GUESSED, WHY)
					: o)
				.toList();
	}

	/** Whether nearly all of the tip is within a width of what comes well before it. */
	private boolean isBeside(final Polyline contour) {
		final double tip = TrackTuning.BESIDE_TIP * width, apart = TrackTuning.BESIDE_APART * width;
		if (contour.length() < tip + 2 * apart)
			return false;
		final long beside = IntStream.rangeClosed(0, SAMPLES)
			.mapToDouble(i -> contour.length() - tip * i / SAMPLES)
			.filter(s -> contour.head(s - apart).distanceTo(contour.at(s)) < width).count();
		return beside > TrackTuning.BESIDE_SHARE * (SAMPLES + 1);
	}
}
