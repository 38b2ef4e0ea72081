package io.github.knotresolver.mask;

/**
 * The numbers by which a frame becomes a mask. Grey values are those of the stretched frame, 0
 * to 1. {@code scripts/ablation} measures what halving and doubling each does.
 */
final class MaskTuning {

	/**
	 * [steps] Time step of the active contour. Why: half the largest that is stable for a front
	 * that moves one pixel a step.
	 */
	static final double TIME_STEP = 0.5;

	/** [px] The front moves no further in a step. Why: it must not jump over a pixel. */
	static final double LONGEST_STEP = 0.5;

	/**
	 * [grey] A window with less contrast is stretched as if it had this. Why: otherwise noise
	 * fills the whole range where there is no filament.
	 */
	static final double LEAST_CONTRAST = 0.2;

	/**
	 * [rounds] How often the means of both sides and the threshold between them are found. Why:
	 * each round moves it less; the third hardly.
	 */
	static final int THRESHOLD_ROUNDS = 3;

	/**
	 * [share] The threshold lies this part of the way from dark to bright. Why: the half height of
	 * a blurred line is where its border is.
	 */
	static final double HALF_WAY = 0.5;

	private MaskTuning() {
	}
}
