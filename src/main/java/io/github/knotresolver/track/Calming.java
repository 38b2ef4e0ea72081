package io.github.knotresolver.track;

import java.util.List;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.progress.Workers;

/** Blurs the frames of a movie whose noise drowns single pixels: a fit would follow the noise. */
final class Calming {

	private Calming() {
	}

	/**
	 * O(pixels).
	 *
	 * @param frames a movie, at least one frame
	 * @param strand brightness of a strand in the frames' units, above 0
	 * @param workers threads
	 * @return the frames, blurred if the median noise of a pixel is too large beside a strand
	 */
	static List<FrameView> of(final List<FrameView> frames, final double strand,
		final Workers workers) {
		return noise(frames, workers) < TrackTuning.NOISY * strand
			? frames
			: workers.map(frames.size(), t -> frames.get(t).blurred(TrackTuning.CALMING));
	}

	/** The median noise of a pixel, in the frames' units. */
	static double noise(final List<FrameView> frames, final Workers workers) {
		return new Median().evaluate(workers.map(frames.size(), t -> frames.get(t).light().noise())
			.stream().mapToDouble(Double::doubleValue).toArray());
	}
}
