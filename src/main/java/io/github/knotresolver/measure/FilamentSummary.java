package io.github.knotresolver.measure;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

/**
 * One filament in a row.
 *
 * @param firstFrame 1-based first frame in which it is in view; empty if it never is
 * @param lastFrame the last one
 * @param length its length in calibrated units: the one that was used or, without
 *          such, the median over the frames; NaN if it has no contour
 * @param lengthError the length's standard error in calibrated units; NaN if it is not
 *          known
 * @param confidence mean over the frames that have a contour; NaN without
 * @param gliding of a free filament; empty for a clamped one, and where it cannot be measured
 */
public record FilamentSummary(OptionalInt firstFrame, OptionalInt lastFrame, double length,
	double lengthError, double confidence, Optional<Gliding> gliding) {

	/**
	 * @param filament a measured filament
	 * @param calibration the movie's
	 * @return its summary
	 */
	public static FilamentSummary of(final MeasuredFilament filament,
		final Calibration calibration) {
		final double pixelSize = calibration.pixelSize();
		final List<Observation> frames = filament.track().frames();
		final double used = filament.track().length() * pixelSize;
		return new FilamentSummary(
			frames.stream().filter(FilamentSummary::isInView).mapToInt(Observation::frame).min(),
			frames.stream().filter(FilamentSummary::isInView).mapToInt(Observation::frame).max(),
			Double.isNaN(used) ? LengthStatistics.of(filament.frames()).median() : used,
			filament.track().lengthError() * pixelSize,
			frames.stream().filter(f -> f.contour().isPresent())
				.mapToDouble(Observation::confidence).filter(Double::isFinite).average()
				.orElse(Double.NaN),
			filament.track().anchor() == Anchor.FREE
				? Gliding.of(frames.stream().map(Observation::contour).toList(), calibration)
				: Optional.empty());
	}

	/**
	 * @param frame a frame of a filament
	 * @return whether the filament is in view; not where the frame was left out, so that nobody knows
	 */
	public static boolean isInView(final Observation frame) {
		return frame.status() != FrameStatus.ABSENT && frame.status() != FrameStatus.IGNORED;
	}
}
