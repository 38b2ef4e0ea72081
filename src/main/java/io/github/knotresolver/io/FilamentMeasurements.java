package io.github.knotresolver.io;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.ContourGeometry;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.OriginalQuantities;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * Measurements of one filament.
 *
 * @param contours what was measured
 * @param measurements what came of it
 */
public record FilamentMeasurements(ContourInput contours, MovieMeasurements measurements) {

	/**
	 * Measures filaments, each by itself. Of several, those without a contour that is
	 * long enough are left out.
	 *
	 * @param filaments at least one
	 * @param options how
	 * @param progress told how far it is; may cancel
	 * @return the measurements, at least one
	 * @throws UserException if nothing can be measured, in one sentence
	 */
	public static List<FilamentMeasurements> of(final List<ContourInput> filaments,
		final MeasureOptions options, final Progress progress) {
		final List<FilamentMeasurements> all = new ArrayList<>();
		try (Workers workers = Workers.ofThisComputer()) {
			for (final ContourInput contours : filaments)
				if (filaments.size() == 1 || isMeasurable(contours))
					all.add(new FilamentMeasurements(contours,
						workers.during(() -> options.measure(contours, progress))));
		}
		if (all.isEmpty())
			throw new UserException("None of the " + filaments.size()
				+ " filaments has a contour that is long enough to be measured.");
		return all;
	}

	private static boolean isMeasurable(final ContourInput contours) {
		return contours.contours().stream()
			.anyMatch(c -> c.filter(ContourGeometry::isMeasurable).isPresent());
	}

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
