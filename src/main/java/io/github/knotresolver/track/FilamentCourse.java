package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

import io.github.knotresolver.fit.FilamentEstimate;

/**
 * What is known about the filament in every frame: what it looks like, where its fixed end
 * is and how long it is.
 *
 * @param estimate what holds for all frames
 * @param anchor where the fixed end is
 * @param length how long the filament is
 * @param noise of a pixel as it was recorded, in strands' brightnesses
 * @param stiffness price of bending
 */
record FilamentCourse(FilamentEstimate estimate, AnchorPath anchor, LengthCourse length,
	double noise, double stiffness) {

	/** What is known of a frame near a break, with the other length that is possible there. */
	FilamentEstimate otherIn(final int index) {
		return in(index).withLength(length.others()[index]);
	}

	FilamentCourse withLength(final LengthCourse other) {
		return new FilamentCourse(estimate, anchor, other, noise, stiffness);
	}

	FilamentCourse withEstimate(final FilamentEstimate other) {
		return new FilamentCourse(other, anchor, length, noise, stiffness);
	}

	FilamentCourse withNoise(final double other) {
		return new FilamentCourse(estimate, anchor, length, other, stiffness);
	}

	/** The noise in units of another estimate's brightness of a strand. */
	double noiseOf(final FilamentEstimate other) {
		return noise * estimate.amplitude() / other.amplitude();
	}

	FilamentCourse withAnchor(final AnchorPath other) {
		return new FilamentCourse(estimate, other, length, noise, stiffness);
	}

	/** What is known of a frame. */
	FilamentEstimate in(final int index) {
		final FilamentEstimate here = estimate.withFixedEnd(anchor.at(index));
		return length.kind() == LengthCourse.Kind.CONSTANT
			? here
			: here.withLength(length.of(index));
	}

	/** What a user should know, one sentence each; frames are those that were resolved. */
	List<String> notes(final List<FrameView> frames) {
		final List<String> notes = new ArrayList<>();
		if (anchor.range() > TrackTuning.NOTED_DRIFT)
			notes.add(String.format(Locale.ROOT,
				"The fixed end moves by up to %.1f px; it was followed from frame to frame.",
				anchor.range()));
		final int first = frames.get(0).frame(), last = frames.get(frames.size() - 1).frame();
		final double perFrame = length.rate() * (frames.size() - 1) / Math.max(1, last - first);
		final double begin = length.of(0), end = length.of(frames.size() - 1);
		final String steady = String.format(Locale.ROOT, "%s by %.3f px per frame",
			perFrame > 0 ? "grows" : "shrinks", Math.abs(perFrame));
		final String broken = length.at() == 0
			? ""
			: String.format(Locale.ROOT, "changes its length at frame %d, from %.1f to %.1f px",
				frames.get(length.at()).frame(), length.of(length.at() - 1),
				length.of(length.at()));
		switch (length.kind()) {
			case STEADY -> notes.add(String.format(Locale.ROOT,
				"The filament %s, from %.1f to %.1f px.", steady, begin, end));
			case BROKEN -> notes.add("The filament " + broken + ".");
			case STEADY_AND_BROKEN ->
				notes.add("The filament " + broken + ", and " + steady + " besides.");
			case PHASES, WANDERING -> notes.add(String.format(Locale.ROOT,
				"The filament's length changes, from %.1f px in frame %d to %.1f px in frame %d.",
				begin, first, end, last));
			case CONSTANT -> {
			}
		}
		return notes;
	}
}
