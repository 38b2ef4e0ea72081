package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * The way of a line that lies still beside something that winds: where both meet twice, the picture
 * leaves open which of them bends in between. A line that lies still is the straighter one.
 *
 * @param light the picture
 * @param width what bends by less goes the same way, in pixels
 * @param bright what is brighter lies in a line
 */
record StraightWay(NormalizedFrame light, double width, double bright) {

	/**
	 * O(points²) stretches, each as long as it is bright.
	 *
	 * @param curve in pixels
	 * @return the curve, straight between any two of its points between which the picture is bright
	 *         all along, the farthest first
	 */
	Polyline of(final Polyline curve) {
		final List<Point> points = new ArrayList<>();
		for (int i = 0; i < curve.size(); i++)
			points.add(curve.point(i));
		for (int span = points.size() - 1; span > 1; span = Math.min(span, points.size()) - 1)
			for (int i = 0; i + span < points.size(); i++)
				if (isBent(points.subList(i, i + span + 1))
					&& isBright(points.get(i), points.get(i + span)))
					points.subList(i + 1, i + span).clear();
		return Polyline.of(points);
	}

	private boolean isBent(final List<Point> stretch) {
		final Polyline chord = Polyline
			.of(List.of(stretch.get(0), stretch.get(stretch.size() - 1)));
		return stretch.stream().anyMatch(p -> chord.distanceTo(p) > width);
	}

	private boolean isBright(final Point from, final Point to) {
		final Polyline chord = Polyline.of(List.of(from, to));
		for (double s = 0; s <= chord.length(); s++) {
			final Point at = chord.at(s);
			if (!(light.meanAround(at.x(), at.y()) > bright))
				return false;
		}
		return true;
	}
}
