package io.github.knotresolver.ui.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;

import org.junit.jupiter.api.Test;

/** Which figures stand together. */
class MeasureTabsTest {

	@Test
	void everyFigureIsOnATabAndNoTabIsEmpty() {
		assertEquals(
			Map.of("Contours", List.of("contours"), "Length, ends", List.of("end_to_end", "length"),
				"Tip angle", List.of("tip_angle", "tip_angle_spectrum"), "Kymographs",
				List.of("curvature_kymograph"), "Other spectra", List.of("length_spectrum")),
			MeasureTabs.of(List.of("contours", "curvature_kymograph", "end_to_end", "length",
				"tip_angle", "tip_angle_spectrum", "length_spectrum")));
		assertEquals(List.of("Contours", "Kymographs"),
			List.copyOf(MeasureTabs.of(List.of("curvature_kymograph", "contours")).keySet()));
	}
}
