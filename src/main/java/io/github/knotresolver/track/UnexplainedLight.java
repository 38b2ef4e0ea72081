
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.ConnectedComponents;
import io.github.knotresolver.mask.ConnectedComponents.MaskObject;

/** Light that the chains of a scene leave, as stretches of a line. */
final class UnexplainedLight {

	private UnexplainedLight() {
	}

	/**
	 * The chains of a scene, made longer where light goes on, and those that are missing.
	 *
	 * @param held so many of the first chains stay as they are
	 */
	static List<Chain> mended(final Scene scene, final int held) {
		final List<Polyline> curves = new ArrayList<>();
		scene.chains().forEach(c -> curves.add(c.polyline()));
		final List<Polyline> added = new ArrayList<>();
		for (final Polyline stretch : stretches(scene.residual()))
			if (stretch.length() >= SceneTuning.LEFT_EXTENDS && !extend(curves, stretch, held)
				&& stretch.length() > SceneTuning.LEFT_OWN)
				added.add(stretch);
		curves.addAll(added);
		final List<Chain> chains = new ArrayList<>();
		for (int k = 0; k < curves.size(); k++)
			chains.add(k < scene.size() && curves.get(k).size() == scene.chain(k).links() + 1
				? scene.chain(k)
				: Chain.inScene(curves.get(k), curves.get(k).length()));
		return chains;
	}

	/** Bright stretches of what is left, each a straight line. */
	static List<Polyline> stretches(final NormalizedFrame residual) {
		final double[] left = residual.blurred(SceneTuning.LEFT_BLUR).pixels();
		final boolean[] bright = new boolean[left.length];
		for (int i = 0; i < left.length; i++)
			bright[i] = left[i] > SceneTuning.LEFT_BRIGHT;
		final int width = residual.width();
		final ConnectedComponents parts = ConnectedComponents.of(Pixels.mask(bright, width));
		final List<Polyline> lines = new ArrayList<>();
		for (final MaskObject part : parts.objects())
			if (part.pixels() >= SceneTuning.LEFT_PIXELS)
				axis(Pixels.bits(parts.mask(part)), width, part).ifPresent(lines::add);
		return lines;
	}

	/** The long axis of a part, from its first to its last pixel along it. */
	private static Optional<Polyline> axis(final boolean[] bits, final int width,
		final MaskObject part) {
		double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
		for (int y = part.minY(); y <= part.maxY(); y++)
			for (int x = part.minX(); x <= part.maxX(); x++)
				if (bits[y * width + x]) {
					n++;
					sx += x;
					sy += y;
					sxx += x * x;
					sxy += x * y;
					syy += y * y;
				}
		final double mx = sx / n, my = sy / n;
		final double angle = 0.5
			* Math.atan2(2 * (sxy / n - mx * my), sxx / n - mx * mx - (syy / n - my * my));
		final double ux = Math.cos(angle), uy = Math.sin(angle);
		double from = Double.POSITIVE_INFINITY, to = Double.NEGATIVE_INFINITY;
		for (int y = part.minY(); y <= part.maxY(); y++)
			for (int x = part.minX(); x <= part.maxX(); x++)
				if (bits[y * width + x]) {
					final double s = (x - mx) * ux + (y - my) * uy;
					from = Math.min(from, s);
					to = Math.max(to, s);
				}
		return to - from < 1
			? Optional.empty()
			: Optional.of(Polyline.of(new double[]{mx + from * ux, mx + to * ux},
				new double[]{my + from * uy, my + to * uy}));
	}

	/** Adds a stretch to the nearest end that goes on there; false if there is none. */
	private static boolean extend(final List<Polyline> curves, final Polyline stretch,
		final int held) {
		double nearest = SceneTuning.LEFT_NEAR;
		int which = -1;
		Polyline longer = null;
		for (int k = held; k < curves.size(); k++)
			for (final Polyline curve : List.of(curves.get(k), curves.get(k).reversed()))
				for (final Polyline beyond : List.of(stretch, stretch.reversed())) {
					final double distance = curve.last().distanceTo(beyond.first());
					if (distance < nearest
						&& alignment(curve, beyond.last()) > SceneTuning.LEFT_ALIGNED) {
						nearest = distance;
						which = k;
						longer = joined(curve, beyond.last());
					}
				}
		if (which >= 0)
			curves.set(which, longer);
		return which >= 0;
	}

	private static double alignment(final Polyline curve, final Point far) {
		final Point end = curve.last(), back = curve.at(curve.length() - SceneTuning.LEFT_END);
		final double ux = end.x() - back.x(), uy = end.y() - back.y();
		final double vx = far.x() - end.x(), vy = far.y() - end.y();
		return (ux * vx + uy * vy) / Math.max(1e-9, Math.hypot(ux, uy) * Math.hypot(vx, vy));
	}

	private static Polyline joined(final Polyline curve, final Point far) {
		final List<Point> points = new ArrayList<>();
		for (int i = 0; i < curve.size(); i++)
			points.add(curve.point(i));
		points.add(far);
		return Polyline.of(points);
	}

	/** A curve with a straight piece of so many pixels at its last point. */
	static Polyline extended(final Polyline curve, final double by) {
		final Point end = curve.last(), back = curve.at(curve.length() - SceneTuning.LEFT_END / 2);
		final double d = Math.max(1e-9, end.distanceTo(back));
		return joined(curve, new Point(end.x() + by * (end.x() - back.x()) / d,
			end.y() + by * (end.y() - back.y()) / d));
	}
}
