package io.github.knotresolver.ui.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Which figures of measurements stand together on a tab. */
public final class MeasureTabs {

	private static final String CONTOURS = "Contours", LENGTHS = "Length, ends",
		ANGLE = "Tip angle", KYMOGRAPHS = "Kymographs", OTHER = "Other spectra";

	private MeasureTabs() {
	}

	/**
	 * @param keys names of figures, in their order
	 * @return the names of the tabs in their order, each with its figures; none is empty
	 */
	public static Map<String, List<String>> of(final List<String> keys) {
		final Map<String, List<String>> tabs = new LinkedHashMap<>();
		for (final String tab : List.of(CONTOURS, LENGTHS, ANGLE, KYMOGRAPHS, OTHER)) {
			final List<String> own = keys.stream().filter(key -> tab(key).equals(tab)).toList();
			if (!own.isEmpty())
				tabs.put(tab, own);
		}
		return tabs;
	}

	private static String tab(final String key) {
		if (key.endsWith("_kymograph"))
			return KYMOGRAPHS;
		return switch (key) {
			case "contours" -> CONTOURS;
			case "length", "end_to_end" -> LENGTHS;
			case "tip_angle", "tip_angle_spectrum" -> ANGLE;
			default -> OTHER;
		};
	}
}
