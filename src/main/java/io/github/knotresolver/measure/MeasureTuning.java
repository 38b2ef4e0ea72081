package io.github.knotresolver.measure;

/**
 * The numbers by which contours are measured. Pixels are those of the movie; a window is that of
 * the smoothing. {@code scripts/measurement-accuracy} shows what they are worth: how far measured
 * values are from the truth, and how often their intervals hold it.
 */
final class MeasureTuning {

	/**
	 * [windows] Errors of curvature are correlated over this part of the window. Why: the second
	 * derivative's filter changes its sign about there.
	 */
	static final double CURVATURE_CORRELATED = 0.2;

	/**
	 * [points] So many lags of the residuals' autocorrelation are compared. Why: points are a pixel
	 * apart and errors correlated over a few.
	 */
	static final int LAGS = 12;

	/**
	 * [points] The shortest range of correlation that is tried. Why: below half a point neighbours
	 * are independent.
	 */
	static final double FIRST_RANGE = 0.4;

	/**
	 * [points] ... and of contours that were fitted to an image. Why: the microscope's blur is no
	 * narrower.
	 */
	static final double BLUR_RANGE = 2;

	/**
	 * [ratio] Each range that is tried is this much longer than the one before. Why: neighbouring
	 * ones cannot be told apart.
	 */
	static final double RANGE_STEP = 1.12;

	/** [windows] ... up to this. Why: what is correlated over more is bending, to the smoothing. */
	static final double LONGEST_RANGE = 0.35;

	/**
	 * [residuals] Fewer say nothing about their correlation. Why: an autocorrelation of thirty has
	 * an error of a fifth.
	 */
	static final int FEWEST_RESIDUALS = 30;

	/**
	 * [contours] Lengths of fewer contours do not tell whether they scatter. Why: a median of fewer
	 * is as uncertain as what it is compared with.
	 */
	static final int FEWEST_LENGTHS = 5;

	/**
	 * [frequencies] A kymograph's spectrum has so many frequencies for each independent one. Why:
	 * its summit is found between them, by a parabola.
	 */
	static final int FIELD_OVERSAMPLING = 8;

	/**
	 * [places] At most so many places of a kymograph are looked at. Why: neighbouring ones say the
	 * same.
	 */
	static final int FIELD_PLACES = 40;

	/**
	 * [points] A contour's motion along itself is the mean at so many points. Why: neighbours
	 * closer than that move together.
	 */
	static final int GLIDING_POINTS = 32;

	/**
	 * [share] A residual shows at least this part of the noise. Why: at a window's end the curve
	 * follows its points, and one would divide by next to nothing.
	 */
	static final double LEAST_FREEDOM = 0.05;

	/**
	 * [ratio] Errors of a smooth fit are so much larger at its ends. Why: it is held from one side
	 * only there: half the points.
	 */
	static final double LOOSE_END = 2;

	/**
	 * [px] Over this length neighbouring places repeat each other's errors. Why: it is the
	 * smoothing's usual window.
	 */
	static final int REPEATED = 12;

	/**
	 * [series] So much noise is simulated for a false-alarm probability. Why: its smallest is then
	 * one in two hundred, far below what is believed.
	 */
	static final int SIMULATIONS = 199;

	/**
	 * [frequencies] Noise has so many frequencies for each independent one. Why: a peak between two
	 * is lowered by a tenth at most, in the series and in the noise.
	 */
	static final int NOISE_OVERSAMPLING = 2;

	/**
	 * [px] Noise is measured from the residuals of a window at least so wide. Why: errors that are
	 * correlated over the microscope's blur leave no residual in a narrower one.
	 */
	static final double NOISE_WINDOW = 12;

	/**
	 * [points] A window holds at least so many points more than the order. Why: with fewer there is
	 * no residual.
	 */
	static final int SPARE_POINTS = 2;

	/** [places] The bias is looked at so often in a window. Why: it changes slowly within one. */
	static final int COMPARED = 8;

	/**
	 * [share] Farther out in its window than this, from the middle (0) to the end (1), a point
	 * counts as near an end. Why: there the filter is no longer symmetric.
	 */
	static final double MIDDLE = 0.1;

	/**
	 * [px] Neighbours within this are left out with a point when it is predicted from the others.
	 * Why: the two beside it share its pixel's error.
	 */
	static final double NEIGHBOURS = 1.5;

	/**
	 * [px] Errors of points so far away are not correlated on a traced contour. Why: it errs from
	 * pixel to pixel.
	 */
	static final double FAR = 5;

	/**
	 * [ratio] If far neighbours predict a point with so much larger an error than near ones, the
	 * filament bends too much, and its errors are taken to be independent. Why: independent errors
	 * and bending of a few windows make it less.
	 */
	static final double FAR_WORSE = 6;

	/**
	 * [contours] So many contours tell over what range errors are correlated. Why: more do not
	 * change the window.
	 */
	static final int WINDOW_CONTOURS = 60;

	/**
	 * [frequencies] A spectrum has so many frequencies for each independent one. Why: its peak is
	 * refined from there by least squares.
	 */
	static final int OVERSAMPLING = 4;

	/** [frames] Fewer values have no spectrum. Why: it has more unknowns than they tell. */
	static final int FEWEST_FRAMES = 8;

	/**
	 * [share] Places whose sine is smaller than this part of the largest have no phase. Why: noise
	 * would turn it.
	 */
	static final double LEAST_AMPLITUDE = 0.2;

	/**
	 * [share] Places seen in less of the movie are left out. Why: gaps put power at wrong
	 * frequencies.
	 */
	static final double LEAST_FRAMES = 0.7;

	/** [places] Fewer places have no slope. Why: a line through four is as good as any. */
	static final int FEWEST_PLACES = 5;

	/**
	 * [places] Turns from frame to frame are the median over so many places. Why: a loop that opens
	 * changes some of them only.
	 */
	static final int TURN_PLACES = 20;

	/** [px] No window is narrower. Why: less is inside the microscope's blur. */
	static final double NARROWEST_WINDOW = 8;

	/**
	 * [ratio] Each window that is tried is so much wider than the one before. Why: the error
	 * changes by less than it is known to.
	 */
	static final double WINDOW_STEP = 1.2;

	/**
	 * [share] This part of the window that is best for points is used. Why: the best for a cubic's
	 * curvature is 0.93 of it (Fan and Gijbels 1995, doi:10.1111/j.2517-6161.1995.tb02034.x); a
	 * little less keeps the bias below the noise, so that standard errors hold (Hall 1992).
	 */
	static final double NARROWER = 0.85;

	/**
	 * [ratio] Wider windows are not tried once the error has grown by this. Why: it does not fall
	 * again.
	 */
	static final double WINDOW_HOPELESS = 4;

	/**
	 * [points] So many points are predicted, over all contours. Why: the mean of their errors is
	 * known to some percent.
	 */
	static final int PREDICTIONS = 1200;

	private MeasureTuning() {
	}
}
