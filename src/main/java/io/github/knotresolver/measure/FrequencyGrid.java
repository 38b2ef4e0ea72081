package io.github.knotresolver.measure;

/**
 * Equally spaced frequencies that all have a whole number of cycles in the same number of frames,
 * so that the phase of each frame is a fraction of a turn that is known exactly.
 *
 * @param first cycles of the lowest frequency, from 1
 * @param size how many there are, from 1
 * @param cycle frames in which these are whole cycles, from 1
 * @param interval time between frames, above 0
 */
record FrequencyGrid(int first, int size, int cycle, double interval) {

	FrequencyGrid {
		if (first < 1 || size < 1 || cycle < 1 || !(interval > 0))
			throw new IllegalArgumentException(
				"A grid of frequencies has at least 1 of at least 1 cycle in at least 1 frame, but this has "
					+ size + " from " + first + " in " + cycle + ", with an interval of " + interval
					+ ".");
	}

	/**
	 * @param frames of a movie, or of a part of it
	 * @param oversampling frequencies for each independent one
	 * @param interval time between frames
	 * @return from one cycle in these frames to half the frame rate
	 */
	static FrequencyGrid over(final int frames, final int oversampling, final double interval) {
		final int cycle = Math.multiplyExact(frames, oversampling);
		return new FrequencyGrid(oversampling, Math.max(1, cycle / 2 - oversampling + 1), cycle,
			interval);
	}

	/** @return frequency {@code k} from 0, in 1/unit of time */
	double frequency(final int k) {
		return (first + k) / (cycle * interval);
	}

	/** @return all of them, ascending */
	double[] frequencies() {
		final double[] all = new double[size];
		for (int k = 0; k < size; k++)
			all[k] = frequency(k);
		return all;
	}
}
