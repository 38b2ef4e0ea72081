package io.github.knotresolver.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Map;
import java.util.Optional;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** What a measurement may be told; its contours are 30 µm long, of pixels of 0.1 µm. */
class MeasureRunTest {

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {
		"smoothing_window|1e300|smoothing_window must be from 0.1 to 60 µm, but is '1e300'.",
		"smoothing_window|1e-300|smoothing_window must be from 0.1 to 60 µm, but is '1e-300'.",
		"persistence_length|1e308|persistence_length must be from 0.000001 to 1000000000, but is '1e308'.",
		"rigidity|1e-300|rigidity must be from 0.000001 to 1000000000 pN µm², but is '1e-300'.",
		"pixel_size|1e308|pixel_size must be from 0.1 nm to 1 mm, but is 1e308 µm."})
	void valuesWithoutPhysicalSenseAreRefused(final String key, final String text,
		final String sentence) {
		assertEquals(sentence,
			assertThrows(UserException.class, () -> measure(key, text)).getMessage());
	}

	@Test
	void theEndsOfARangeBelongToIt() {
		measure("smoothing_window", "0.1");
		measure("smoothing_window", "60");
	}

	private static void measure(final String key, final String text) {
		final double[] x = new double[301], y = new double[301];
		for (int i = 0; i < x.length; i++)
			x[i] = i;
		final Optional<Polyline> line = Optional.of(Polyline.of(x, y));
		MeasureRun.parse(Map.of(key, text)).measure(
			new ContourInput("lines", List.of(line, line), new Calibration(0.1, "µm", 1, "s"), 0),
			Progress.NONE);
	}
}
