package io.github.knotresolver.io;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.OriginalQuantities;
import io.github.knotresolver.model.Calibration;

/**
 * Measurements of one filament.
 *
 * @param contours what was measured
 * @param measurements what came of it
 */
public record FilamentMeasurements(ContourInput contours, MovieMeasurements measurements) {

	/** @return the filament's number */
	public int filament() {
		return contours.filament();
	}

	/** @return the quantities by the original tool's definitions */
	public OriginalQuantities originalQuantities() {
		final Calibration c = measurements.calibration();
		final List<Integer> frames = new ArrayList<>();
		final List<Polyline> lines = new ArrayList<>();
		for (int i = 0; i < contours.contours().size(); i++) {
			if (contours.contours().get(i).isEmpty())
				continue;
			frames.add(i + 1);
			lines.add(contours.contours().get(i).orElseThrow());
		}
		return OriginalQuantities.of(frames, lines, c.pixelSize(), c.frameInterval());
	}
}
