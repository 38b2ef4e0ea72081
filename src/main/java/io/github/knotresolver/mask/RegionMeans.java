package io.github.knotresolver.mask;

/**
 * Mean intensities of the two regions of a frame.
 *
 * @param inside mean inside the mask
 * @param outside mean outside the mask
 */
record RegionMeans(double inside, double outside) {

	static RegionMeans of(final float[] values, final SparseField field) {
		double all = 0;
		double inside = 0;
		int count = 0;
		for (int at = 0; at < values.length; at++) {
			all += values[at];
			if (!field.contains(at))
				continue;
			inside += values[at];
			count++;
		}
		return new RegionMeans(inside / count, (all - inside) / (values.length - count));
	}

	/**
	 * How much a value is like the inside: 1 at the mean inside, -1 at the mean
	 * outside, within -1..1; 0 if the inside is no brighter or a region is empty.
	 */
	double likeness(final double value) {
		if (!(inside > outside))
			return 0;
		return Math.max(-1, Math.min(1, (2 * value - inside - outside) / (inside - outside)));
	}
}
