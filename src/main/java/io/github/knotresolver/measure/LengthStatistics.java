package io.github.knotresolver.measure;

import java.util.List;

import org.apache.commons.math3.stat.descriptive.DescriptiveStatistics;

/**
 * Lengths over the frames that have a contour, in the unit of length; NaN if
 * there is none.
 *
 * @param mean their mean
 * @param median their median
 * @param sd their standard deviation (n - 1)
 * @param min the shortest
 * @param max the longest
 */
public record LengthStatistics(double mean, double median, double sd, double min, double max) {

	/**
	 * @param frames measured frames
	 * @return the statistics of their lengths
	 */
	public static LengthStatistics of(final List<MeasuredFrame> frames) {
		return ofLengths(frames.stream().mapToDouble(MeasuredFrame::length).toArray());
	}

	/**
	 * @param lengths lengths; those that are NaN do not count
	 * @return their statistics
	 */
	public static LengthStatistics ofLengths(final double[] lengths) {
		final DescriptiveStatistics s = new DescriptiveStatistics();
		for (final double length : lengths)
			if (!Double.isNaN(length))
				s.addValue(length);
		return new LengthStatistics(s.getMean(), s.getPercentile(50), s.getStandardDeviation(),
			s.getMin(), s.getMax());
	}
}
