package io.github.knotresolver.candidate;

import java.util.List;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Step;

/**
 * A possible contour: a walk over the segments of a skeleton graph, from the
 * fixed end to the tip. {@code contour.ContourBuilder} makes a smooth curve of
 * it.
 *
 * @param steps the segments in the order of walking, at least one; each begins
 *          at the node where the one before ends
 * @param end where the walk ends within the last step, in pixels of arc length
 *          from that step's beginning; above 0, at most the step's length
 * @param price what speaks against it
 */
public record Candidate(List<Step> steps, double end, Price price) {

	public Candidate {
		steps = List.copyOf(steps);
		if (steps.isEmpty())
			throw new IllegalArgumentException("A candidate needs at least one step.");
		final double last = steps.get(steps.size() - 1).length();
		if (!(end > 0 && end <= last))
			throw new IllegalArgumentException("A candidate must end within its last step of "
				+ last + " px, but ends at " + end + " px.");
		for (int i = 1; i < steps.size(); i++)
			if (steps.get(i).from().id() != steps.get(i - 1).to().id())
				throw new IllegalArgumentException(
					"Step " + i + " begins at node " + steps.get(i).from().id()
						+ ", but the step before ends at node " + steps.get(i - 1).to().id() + ".");
	}

	/**
	 * A walk that ends with its last segment.
	 *
	 * @param steps the segments in the order of walking
	 * @param price what speaks against it
	 * @return the candidate
	 */
	public static Candidate whole(final List<Step> steps, final Price price) {
		return new Candidate(steps, steps.get(steps.size() - 1).length(), price);
	}

	/** @return whether the walk ends inside its last segment */
	public boolean endsInside() {
		return end < steps.get(steps.size() - 1).length();
	}

	/** @return length of the walk in pixels */
	public double length() {
		double length = end;
		for (int i = 0; i < steps.size() - 1; i++)
			length += steps.get(i).length();
		return length;
	}

	/**
	 * The segments' curves one after another: lightly smoothed within segments,
	 * with corners at the nodes.
	 *
	 * @return the way walked, in pixels, from the fixed end
	 */
	public Polyline path() {
		final int n = steps.stream().mapToInt(s -> s.segment().curve().size() - 1).sum() + 1;
		final double[] x = new double[n], y = new double[n];
		int filled = 0;
		for (final Step step : steps) {
			final Polyline curve = step.segment().curve();
			final int last = curve.size() - 1;
			for (int i = 0; i <= last; i++) {
				x[filled + i] = curve.x(step.forward() ? i : last - i);
				y[filled + i] = curve.y(step.forward() ? i : last - i);
			}
			filled += last;
		}
		return Polyline.of(x, y).head(length());
	}

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
}
