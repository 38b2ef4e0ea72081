package io.github.knotresolver.geometry;

import java.util.Optional;

/**
 * A contour that is held at one place and drawn elsewhere: what is near along the contour follows,
 * what is far stays.
 *
 * @param contour the contour, fixed end first, in pixels
 * @param held arc length of the place that is held, in pixels
 */
public record Drag(Polyline contour, double held) {

	/** Spacing of the points that are drawn, in pixels. */
	private static final double STEP = 1.5;

	/** This part of the contour to either side follows. */
	public static final double FOLLOWING = 0.2;

	/**
	 * @param contour a contour in pixels
	 * @param place where the mouse was pressed
	 * @param reach how far from the contour it may be, in pixels
	 * @return the contour, held there, at its tip if that is in reach; empty if nothing is
	 */
	public static Optional<Drag> at(final Polyline contour, final Point place, final double reach) {
		if (contour.last().distanceTo(place) <= reach)
			return Optional.of(tip(contour));
		return Optional.of(nearest(contour, place))
			.filter(d -> contour.at(d.held).distanceTo(place) <= reach);
	}

	/**
	 * @param contour a contour in pixels
	 * @param place anywhere
	 * @return the contour, held at its point nearest to the place
	 */
	public static Drag nearest(final Polyline contour, final Point place) {
		final Polyline line = contour.resampled(STEP / 2);
		int nearest = 0;
		for (int i = 1; i < line.size(); i++)
			if (line.point(i).distanceTo(place) < line.point(nearest).distanceTo(place))
				nearest = i;
		return new Drag(contour, line.arc(nearest) / line.length() * contour.length());
	}

	/**
	 * @param contour a contour in pixels
	 * @return the contour, held at its tip
	 */
	public static Drag tip(final Polyline contour) {
		return new Drag(contour, contour.length());
	}

	/** @return whether the tip is held */
	public boolean isOfTip() {
		return held >= contour.length();
	}

	/**
	 * @param place where the mouse is
	 * @return the contour as it is drawn meanwhile
	 */
	public Polyline to(final Point place) {
		final Point from = contour.at(held);
		final Polyline line = contour.resampled(STEP);
		final double[] x = line.xs(), y = line.ys();
		for (int i = 0; i < x.length; i++) {
			final double away = Math.abs(contour.length() * i / (x.length - 1) - held)
				/ (FOLLOWING * contour.length());
			final double share = away < 1 ? Math.pow(Math.cos(away * Math.PI / 2), 2) : 0;
			x[i] += share * (place.x() - from.x());
			y[i] += share * (place.y() - from.y());
		}
		return Polyline.of(x, y);
	}
}
