package io.github.knotresolver.candidate;

/**
 * What speaks against a walk, without looking at other frames. All parts are in
 * pixels, weights included, so they add up.
 *
 * @param turning sharp turns at junctions
 * @param uncovered skeleton that the walk leaves out
 * @param lengthMisfit how much longer or shorter than the known length it is; 0
 *          if the length is not known
 * @param overlap what it walks twice
 * @param start how much farther than need be it begins from the fixed end
 */
public record Price(double turning, double uncovered, double lengthMisfit, double overlap,
	double start) {

	/** Nothing speaks against it, or prices do not matter. */
	public static final Price NONE = new Price(0, 0, 0, 0, 0);

	/** @return the sum of the parts, in pixels */
	public double total() {
		return turning + uncovered + lengthMisfit + overlap + start;
	}
}
