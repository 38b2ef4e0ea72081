package io.github.knotresolver.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class RobustStatisticsTest {

	@Test
	void ofTwoInTheMiddleTheMedianIsTheirMeanAndTheUpperOneTheLarger() {
		final double[] values = {7, -1, 4, 2};
		assertEquals(3, RobustStatistics.median(values));
		assertEquals(4, RobustStatistics.upperMedian(values, 0));
		assertArrayEquals(new double[]{7, -1, 4, 2}, values, "not changed");
		assertEquals(2, RobustStatistics.upperMedian(new double[]{9, 2, 1}, 0));
	}

	@Test
	void ofNothingItIsWhatIsAskedFor() {
		assertEquals(Double.NaN, RobustStatistics.median(new double[0]));
		assertEquals(5, RobustStatistics.median(new double[0], 5));
		assertEquals(5, RobustStatistics.upperMedian(new double[0], 5));
	}
}
