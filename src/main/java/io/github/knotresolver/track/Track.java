package io.github.knotresolver.track;

import java.util.List;
import java.util.Map;

import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

/**
 * What was found of one filament in the frames that were asked for, in their pixels.
 *
 * @param fixedEnd where it is clamped
 * @param length its length in pixels that was used; NaN if none was
 * @param lengthError the length's standard error in pixels; NaN if it is not known
 * @param frames one for each frame asked for, in the same order
 * @param notes what a user should know, one sentence each
 */
public record Track(Point fixedEnd, double length, double lengthError, List<Observation> frames,
	List<String> notes) {

	public Track {
		frames = List.copyOf(frames);
		notes = List.copyOf(notes);
	}

	/**
	 * @param others one for each of its frames, in the same order
	 * @return the same with these
	 */
	public Track withFrames(final List<Observation> others) {
		return new Track(fixedEnd, length, lengthError, others, notes);
	}

	/**
	 * @param estimate length and fixed end that the fits were made with
	 * @param contours fitted ones by 1-based frame
	 * @return the same with these, where the user did not give the contour
	 */
	Track fitted(final FilamentEstimate estimate, final Map<Integer, Polyline> contours) {
		return new Track(estimate.fixedEnd(), estimate.length(), estimate.lengthError(),
			frames.stream()
				.map(f -> f.status() == FrameStatus.CORRECTED || !contours.containsKey(f.frame())
					? f
					: f.withContour(contours.get(f.frame())))
				.toList(),
			notes);
	}

	/**
	 * @param frames what was found on skeletons
	 * @return what a user should know of them
	 */
	public static List<String> notes(final List<Observation> frames) {
		return frames.stream().noneMatch(f -> f.status() == FrameStatus.UNRESOLVED)
			? List.of()
			: List.of("Some frames could not be resolved; frames.csv says why.");
	}
}
