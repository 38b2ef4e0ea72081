
package io.github.knotresolver.measure;

import java.util.Arrays;

/**
 * A quantity over the frames of a movie. A value that is NaN is missing: it
 * takes no part in anything.
 */
final class TimeSeries {

	private final double[] time;
	private final double[] value;
	private final double interval;

	private TimeSeries(final double[] time, final double[] value, final double interval) {
		this.time = time;
		this.value = value;
		this.interval = interval;
	}

	/** @return the values that are present, with their times */
	static TimeSeries of(final double[] values, final double interval) {
		if (!(interval > 0))
			throw new IllegalArgumentException(
				"The frame interval must be above 0, but is " + interval + ".");
		final int n = (int) Arrays.stream(values).filter(Double::isFinite).count();
		final double[] time = new double[n], value = new double[n];
		int k = 0;
		for (int i = 0; i < values.length; i++) {
			if (!Double.isFinite(values[i]))
				continue;
			time[k] = i * interval;
			value[k++] = values[i];
		}
		return new TimeSeries(time, value, interval);
	}

	int size() {
		return time.length;
	}

	double time(final int i) {
		return time[i];
	}

	/** @return index of the frame, from 0 */
	int frame(final int i) {
		return (int) Math.rint(time[i] / interval);
	}

	double value(final int i) {
		return value[i];
	}

	double interval() {
		return interval;
	}

	/** @return how many frames there are from the first value to the last */
	int frames() {
		return frame(size() - 1) - frame(0) + 1;
	}

	/** @return duration of the frames between the first and last value */
	double duration() {
		return time[time.length - 1] - time[0] + interval;
	}

	boolean isVaried() {
		return size() >= MeasureTuning.FEWEST_FRAMES && variance() > 0;
	}

	/** @return the values less their straight line of least squares */
	TimeSeries detrended() {
		final int n = size();
		final double mt = Arrays.stream(time).sum() / n;
		final double mv = Arrays.stream(value).sum() / n;
		double tt = 0, tv = 0;
		for (int i = 0; i < n; i++) {
			tt += (time[i] - mt) * (time[i] - mt);
			tv += (time[i] - mt) * (value[i] - mv);
		}
		final double slope = tt > 0 ? tv / tt : 0;
		final double[] rest = new double[n];
		for (int i = 0; i < n; i++)
			rest[i] = value[i] - mv - slope * (time[i] - mt);
		return with(rest);
	}

	/** @return the same times with other values */
	TimeSeries with(final double[] values) {
		return new TimeSeries(time, values, interval);
	}

	/** @return mean square of the values */
	double variance() {
		return Arrays.stream(value).map(v -> v * v).sum() / size();
	}

	/**
	 * Correlation of neighbouring frames, corrected for its bias in short series
	 * (Mudelsee 2002, doi:10.1016/S0098-3004(01)00041-3); -0.9 to 0.98.
	 */
	double correlation() {
		double product = 0, square = 0;
		int pairs = 0;
		for (int i = 1; i < size(); i++) {
			if (time[i] - time[i - 1] > 1.5 * interval)
				continue;
			product += value[i] * value[i - 1];
			square += (value[i] * value[i] + value[i - 1] * value[i - 1]) / 2;
			pairs++;
		}
		if (pairs < 3 || square == 0)
			return 0;
		final double r = product / square;
		return Math.max(-0.9, Math.min(0.98, r + (1 + 4 * r) / pairs));
	}
}
