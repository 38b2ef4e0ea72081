package io.github.knotresolver.track;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;

/**
 * What the user said about one frame, as a question to a contour.
 *
 * @param constraints all of that frame, in their own order, at least one
 * @param sigma width of the line in pixels
 */
record Restriction(List<Constraint> constraints, double sigma) {

	Restriction {
		constraints = List.copyOf(constraints);
	}

	/** @return the whole contour, if it was given; of several the last */
	Optional<Polyline> contour() {
		return constraints.stream().filter(c -> c.kind() == Kind.CONTOUR).map(Constraint::shape)
			.reduce((first, last) -> last);
	}

	/** @return whether a contour, from the fixed end to the tip, is as the user said */
	boolean isMetBy(final Polyline contour) {
		return isMetBy(contour, 1);
	}

	/** @return whether a contour that has not been fitted may become one that is */
	boolean isNearlyMetBy(final Polyline contour) {
		return isMetBy(contour, 2);
	}

	private boolean isMetBy(final Polyline contour, final double slack) {
		final double reach = slack
			* Math.max(TrackTuning.SHOWN_LEAST, TrackTuning.SHOWN_WIDTHS * sigma);
		return constraints.stream().allMatch(c -> switch (c.kind()) {
			case CONTOUR, SWAP, CHECKED -> true;
			case TIP -> contour.last().distanceTo(c.shape().first()) <= reach;
			case THROUGH -> IntStream.range(0, c.shape().size())
				.allMatch(i -> contour.distanceTo(c.shape().point(i)) <= reach);
			case NOT -> slack > 1 || differs(contour, c.shape());
		});
	}

	private static boolean differs(final Polyline contour, final Polyline refused) {
		final int links = Math.max(2, (int) Math.min(contour.length(), refused.length()) / 2);
		return Chain.along(contour, links, contour.length())
			.distance(Chain.along(refused, links, refused.length())) > TrackTuning.VISIBLE;
	}

	/** @return what is said of a frame whose contour is as the user said */
	String met() {
		return constraints.stream().allMatch(c -> c.kind() == Kind.NOT)
			? "Another contour than the one that the user refused."
			: "As the user said.";
	}

	/** @return what is said of a frame for which there is no such contour */
	String unmet() {
		return "No contour that explains the picture is as the user said; draw the whole contour.";
	}
}
