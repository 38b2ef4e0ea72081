package io.github.knotresolver.imagej.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.imagej.accuracy.Coverage.Tally;
import io.github.knotresolver.measure.Quantity;

/**
 * The whole way in small: simulated, drawn at 10 dB, resolved with the
 * defaults, measured. {@code scripts/measurement-accuracy} does it at length.
 */
class MeasuredMoviesTest {

	/** Movies of 8, 11 and 14 µm. */
	private static final int[] FILAMENTS = {1, 2, 3};

	@Test
	void lengthsAreUnbiasedAndIntervalsHoldAtTenDecibel() {
		final Coverage coverage = new Coverage();
		double length = 0;
		for (final int k : FILAMENTS) {
			final Coverage movie = MeasurementAccuracyMain.coverage(Pictures.PAPER_10, k, 20);
			length += movie.of(Quantity.LENGTH).meanRelativeError() / FILAMENTS.length;
			coverage.add(movie);
		}
		assertEquals(0, coverage.wrong());
		assertEquals(60, coverage.frames());
		assertEquals(0, length, 0.005, "mean error of the length");
		assertEquals(0, coverage.of(Quantity.END_TO_END).meanError(), 0.005 * 11,
			"mean error of the end-to-end distance, µm");
		int covered = 0, cases = 0;
		for (final Quantity q : List.of(Quantity.LENGTH, Quantity.END_TO_END, Quantity.TIP_ANGLE)) {
			final Tally tally = coverage.of(q);
			covered += (int) Math.rint(tally.covered() * tally.cases());
			cases += tally.cases();
		}
		// 95 % of 180, but the frames of a movie have errors in common.
		assertTrue(covered >= 0.85 * cases, covered + " of " + cases);
	}
}
