package io.github.knotresolver.track;

import java.util.List;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.geometry.Polyline;

/**
 * The contours among which one frame has the choice: a column of the trellis.
 *
 * @param contours in pixels, fixed end first
 * @param prices what speaks against each, without looking at other frames
 * @param limited whether a limit of the search was hit
 */
public record FrameCandidates(List<Polyline> contours, List<Double> prices, boolean limited) {

	/** A frame in which nothing can be chosen. */
	public static final FrameCandidates NONE = new FrameCandidates(List.of(), List.of(), false);

	public FrameCandidates {
		contours = List.copyOf(contours);
		prices = List.copyOf(prices);
		if (contours.size() != prices.size())
			throw new IllegalArgumentException(
				"There must be one price for each contour, but there are " + prices.size() + " for "
					+ contours.size() + " contours.");
	}

	/**
	 * The contours of a generator's candidates.
	 *
	 * @param set the candidates
	 * @return their smooth contours and their prices
	 */
	public static FrameCandidates of(final CandidateSet set) {
		return new FrameCandidates(set.candidates().stream().map(ContourBuilder::smooth).toList(),
			set.candidates().stream().map(Candidate::price).map(p -> p.total()).toList(),
			set.limited());
	}

	/**
	 * The only choice.
	 *
	 * @param contour the contour the user gave
	 * @return that contour, for nothing
	 */
	public static FrameCandidates only(final Polyline contour) {
		return new FrameCandidates(List.of(contour), List.of(0.0), false);
	}

	double[] priceArray() {
		return prices.stream().mapToDouble(Double::doubleValue).toArray();
	}
}
