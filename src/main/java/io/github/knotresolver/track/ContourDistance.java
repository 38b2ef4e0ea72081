package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.contour.DynamicTimeWarping;
import io.github.knotresolver.contour.EqualArcDistance;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * How far contours of neighbouring frames are apart, as an edge price of the trellis:
 * half the normalised dynamic time warping (the same place) and half the mean distance at
 * equal arc length (the same material). Contours are sampled every 4 px. For pairs whose
 * equal-arc distance is hopeless it stands in for the warping as well: it is no less, and
 * much faster. Distances are taken in units of how far the filament typically moves
 * from frame to frame, so that a long frame interval does not drown the contours' own
 * prices, and they count logarithmically when they are large (5 log(1 + d/5)): one jump
 * must not force its neighbours. All prices are computed once, at construction:
 * O(frames * contours² * length²).
 */
public final class ContourDistance implements Trellis.EdgePrice {

	private final double weight;
	private final double typical;
	private final double[][][] fromFrame;

	/**
	 * Computes the prices.
	 *
	 * @param contours for each frame its contours, in pixels, the most likely first; none
	 *          in frames that are skipped
	 * @param weight price of moving as far as is typical (at least 1 px), at least 0
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	public ContourDistance(final List<List<Polyline>> contours, final double weight,
		final Workers workers, final Progress progress) {
		if (!(weight >= 0))
			throw new IllegalArgumentException(
				"The weight of the distance must be at least 0, but is " + weight + ".");
		final List<List<Polyline>> sampled = contours.stream()
			.map(frame -> frame.stream().map(c -> c.every(TrackTuning.DISTANCE_STEP)).toList())
			.toList();
		fromFrame = workers
			.map(sampled.size(), t -> distances(sampled.get(t), next(sampled, t), progress))
			.toArray(double[][][]::new);
		this.weight = weight;
		typical = typical();
	}

	/** Median distance of the most likely contour of a frame to the nearest of the next. */
	private double typical() {
		final double[] moved = Arrays.stream(fromFrame).filter(m -> m.length > 0 && m[0].length > 0)
			.mapToDouble(m -> Arrays.stream(m[0]).min().orElseThrow()).toArray();
		return Math.max(TrackTuning.SKELETON_NOISE, RobustStatistics.upperMedian(moved, 0));
	}

	/**
	 * The price of one pair; neighbours only, frames without contours skipped.
	 */
	@Override
	public double between(final int from, final int fromContour, final int to,
		final int toContour) {
		return weight * TrackTuning.JUMP
			* Math.log1p(fromFrame[from][fromContour][toContour] / (typical * TrackTuning.JUMP));
	}

	private static List<Polyline> next(final List<List<Polyline>> frames, final int t) {
		return frames.subList(t + 1, frames.size()).stream().filter(f -> !f.isEmpty()).findFirst()
			.orElse(List.of());
	}

	private static double[][] distances(final List<Polyline> from, final List<Polyline> to,
		final Progress progress) {
		final double[][] matrix = new double[from.size()][to.size()];
		for (int i = 0; i < matrix.length; i++) {
			progress.checkCancelled();
			for (int j = 0; j < to.size(); j++)
				matrix[i][j] = EqualArcDistance.meanOfSampled(from.get(i), to.get(j));
			final double hopeless = Arrays.stream(matrix[i]).min().orElse(0) + TrackTuning.WARP;
			for (int j = 0; j < to.size(); j++)
				if (matrix[i][j] <= hopeless)
					matrix[i][j] = 0.5
						* (matrix[i][j] + DynamicTimeWarping.normalised(from.get(i), to.get(j)));
		}
		return matrix;
	}
}
