
package io.github.knotresolver.candidate;

import java.util.OptionalDouble;

import io.github.knotresolver.candidate.Candidate.Price;

/** Prices trails of one graph, finished ones and those under way. */
final class TrailPricing {

	private final TrailCandidates.Prices weights;
	private final OptionalDouble known;
	private final double total;
	private final double overlap;

	/**
	 * @param known the filament's length in pixels, if known
	 * @param total length of the skeleton in pixels
	 */
	TrailPricing(final TrailCandidates.Prices weights, final OptionalDouble known,
		final double total) {
		this.weights = weights;
		this.known = known;
		this.total = total;
		overlap = known.isPresent() ? weights.overlap() : weights.overlapUnknown();
	}

	/** The price if the trail ends so many pixels into its last step. */
	Price price(final Trail trail, final double end) {
		final double length = trail.lengthBefore() + end, covered = trail.covered(end);
		return new Price(weights.turning() * trail.turning(),
			weights.uncovered() * Math.max(0, total - covered), misfit(length),
			overlap * Math.max(0, length - covered), trail.start());
	}

	/**
	 * What the trail costs at least, ended inside its last step, at its end or
	 * somewhere beyond: there it goes straight on, covers new skeleton as long as
	 * there is any, and ends where that is best.
	 */
	double bound(final Trail trail) {
		final OptionalDouble cut = cut(trail);
		final double beyond = boundBeyond(trail);
		return cut.isPresent() ? Math.min(beyond, price(trail, cut.getAsDouble()).total()) : beyond;
	}

	/** Where in its last step the known length is used up, if it is. */
	OptionalDouble cut(final Trail trail) {
		if (known.isEmpty())
			return OptionalDouble.empty();
		final double end = known.getAsDouble() - trail.lengthBefore();
		return end >= CandidateTuning.SHORTEST_CUT
			&& end <= trail.lastLength() - CandidateTuning.SHORTEST_CUT
				? OptionalDouble.of(end)
				: OptionalDouble.empty();
	}

	private double boundBeyond(final Trail trail) {
		final double length = trail.length(), covered = trail.covered(trail.lastLength());
		final double open = Math.max(0, total - covered);
		double best = Math.min(rest(length, covered, 0), rest(length, covered, open));
		if (known.isPresent() && known.getAsDouble() > length)
			best = Math.min(best, rest(length, covered, known.getAsDouble() - length));
		return weights.turning() * trail.turning() + trail.start() + best;
	}

	private double rest(final double length, final double covered, final double more) {
		final double then = Math.min(total, covered + more);
		return weights.uncovered() * (total - then) + misfit(length + more)
			+ overlap * Math.max(0, length + more - then);
	}

	private double misfit(final double length) {
		return known.isPresent()
			? weights.lengthMisfit() * Math.abs(length - known.getAsDouble())
			: 0;
	}
}
