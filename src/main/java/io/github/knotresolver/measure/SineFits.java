package io.github.knotresolver.measure;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;

/**
 * Amplitudes of the weighted least squares of a cos + b sin + c at all frequencies of a grid, prepared
 * for one set of times, so that many series can be fitted quickly: O(n log n) for n values and
 * frequencies together, linear in memory.
 */
final class SineFits {

	private final FrequencyGrid grid;
	private final double[] weight;
	/** Of each value, from the first. */
	private final int[] frame;
	private final ChirpTransform transform;
	private final SineFit.Moments[] moments;

	private SineFits(final TimeSeries series, final FrequencyGrid grid, final double[] weight) {
		this.grid = grid;
		this.weight = weight;
		final double total = Arrays.stream(weight).sum();
		frame = new int[series.size()];
		for (int i = 0; i < frame.length; i++) {
			weight[i] /= total;
			frame[i] = series.frame(i) - series.frame(0);
		}
		final int frames = frame[frame.length - 1] + 1;
		transform = new ChirpTransform(frames, grid, 1);
		final double[] spread = spread(i -> weight[i]);
		final double[][] once = transform.sums(spread),
			twice = new ChirpTransform(frames, grid, 2).sums(spread);
		moments = new SineFit.Moments[grid.size()];
		Arrays.setAll(moments,
			k -> SineFit.Moments.of(once[0][k], once[1][k], twice[0][k], twice[1][k]));
	}

	/** Weights: Hann's window over the duration of the series. */
	static SineFits tapered(final TimeSeries series, final FrequencyGrid grid) {
		final double[] w = new double[series.size()];
		final double start = series.time(0) - series.interval() / 2;
		for (int i = 0; i < w.length; i++)
			w[i] = Math.pow(Math.sin(Math.PI * (series.time(i) - start) / series.duration()), 2);
		return new SineFits(series, grid, w);
	}

	/** All values weigh the same. */
	static SineFits plain(final TimeSeries series, final FrequencyGrid grid) {
		final double[] w = new double[series.size()];
		Arrays.fill(w, 1);
		return new SineFits(series, grid, w);
	}

	FrequencyGrid grid() {
		return grid;
	}

	/**
	 * @param series values at the times for which this was prepared
	 * @return for each frequency
	 */
	double[] amplitudes(final TimeSeries series) {
		double sum = 0;
		for (int i = 0; i < frame.length; i++)
			sum += weight[i] * series.value(i);
		final double mean = sum;
		final double[][] sums = transform.sums(spread(i -> weight[i] * series.value(i)));
		final double[] out = new double[grid.size()];
		Arrays.setAll(out, k -> {
			final double[] c = moments[k].coefficients(mean, sums[0][k], sums[1][k]);
			return Math.hypot(c[0], c[1]);
		});
		return out;
	}

	/** One number a frame, 0 where the series has no value. */
	private double[] spread(final IntToDoubleFunction value) {
		final double[] all = new double[frame[frame.length - 1] + 1];
		for (int i = 0; i < frame.length; i++)
			all[frame[i]] = value.applyAsDouble(i);
		return all;
	}
}
