package io.github.knotresolver.ui.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.options.InputOptions;

/** Tuning a segmentation, without any window. */
class TuneModelTest {

	private final TuneModel model = new TuneModel(
		ImageMovie.of(SampleMovie.open(), InputOptions.DEFAULT), 5);

	@AfterEach
	void close() {
		model.close();
	}

	@Test
	void stripAndHistogramSayWhatAThresholdDoes() throws Exception {
		model.atRest();
		assertEquals(5, model.look().orElseThrow().frame());
		assertTrue(Arrays.stream(model.objects()).allMatch(n -> n == 1),
			Arrays.toString(model.objects()));
		final int[] automatic = model.areas();
		assertEquals(100 * 54, Arrays.stream(model.histogram()).sum());
		assertTrue(model.automatic().orElseThrow() > 0.1 && model.automatic().getAsDouble() < 0.9);
		model.set("iterations", "0");
		model.set("threshold", "0.15");
		model.atRest();
		assertTrue(Arrays.stream(model.objects()).max().getAsInt() > 1, "There is no flood.");
		assertEquals(model.areas()[4], model.look().orElseThrow().area());
		model.set("threshold", "1");
		model.atRest();
		assertTrue(Arrays.stream(model.areas()).sum() < Arrays.stream(automatic).sum() / 2);
		model.reset();
		model.atRest();
		assertEquals(TuneModel.AUTOMATIC, model.texts());
		assertArrayEquals(automatic, model.areas());
	}

	@Test
	void framesAreGoneThroughAndWrongValuesAreSaid() throws Exception {
		model.goTo(99);
		model.atRest();
		assertEquals(24, model.look().orElseThrow().frame());
		model.set("log_size", "4");
		assertTrue(model.line().startsWith("log_size and log_sigma go together"), model.line());
		model.set("log_sigma", "1.5");
		assertTrue(model.line().startsWith("log_size must be an odd number"), model.line());
		model.set("log_size", "9");
		model.atRest();
		assertTrue(model.line().startsWith("frame 24: "), model.line());
	}
}
