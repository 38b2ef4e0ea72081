package io.github.knotresolver.track;

import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.RobustStatistics;

/**
 * A clamp after which a filament's light begins: something bright lay there and was taken off with
 * light of the filament, or the filament is dark there. As it turns, where its light begins goes
 * around the clamp, and looks like a clamp that moves.
 */
final class StillPivot {

	private StillPivot() {
	}

	/**
	 * O(frames²), of many frames only some.
	 *
	 * @param begun contours that begin where their light does, frame by frame
	 * @return the place that they turn around, in pixels; empty if they do not turn enough to tell, if
	 *         they begin before it, or if it does not stay
	 */
	static Optional<Point> of(final List<Chain> begun) {
		final List<Point> from = begun.stream().map(Chain::start).toList();
		final Point late = late(begun);
		final List<Point> earlier = begun.stream()
			.map(c -> new Point(c.start().x() - turned(late, c).x(),
				c.start().y() - turned(late, c).y()))
			.toList();
		return late.x() > 0 && !AnchorPath.moves(earlier, TrackTuning.STILL_END)
			&& spread(earlier) < TrackTuning.PIVOT_BETTER * spread(from)
				? Optional.of(RobustStatistics.upperMedian(earlier))
				: Optional.empty();
	}

	/**
	 * From where the filament turns to where its light begins, along it and to its side, as pairs of
	 * frames say between which it turned.
	 */
	private static Point late(final List<Chain> begun) {
		final int step = 1 + begun.size() / TrackTuning.PIVOT_FRAMES;
		final DoubleStream.Builder along = DoubleStream.builder(), beside = DoubleStream.builder();
		for (int i = 0; i < begun.size(); i += step)
			for (int j = 0; j < i; j += step) {
				final Chain a = begun.get(i), b = begun.get(j);
				final double u = Math.cos(a.angle(0)) - Math.cos(b.angle(0)),
					v = Math.sin(a.angle(0)) - Math.sin(b.angle(0)), turned = u * u + v * v,
					x = a.start().x() - b.start().x(), y = a.start().y() - b.start().y();
				if (turned > TrackTuning.PIVOT_TURNED * TrackTuning.PIVOT_TURNED) {
					along.add((u * x + v * y) / turned);
					beside.add((u * y - v * x) / turned);
				}
			}
		return new Point(RobustStatistics.median(along.build().toArray(), 0),
			RobustStatistics.median(beside.build().toArray(), 0));
	}

	/** A way along a chain and to its side, in the picture. */
	private static Point turned(final Point way, final Chain chain) {
		final double cos = Math.cos(chain.angle(0)), sin = Math.sin(chain.angle(0));
		return new Point(cos * way.x() - sin * way.y(), sin * way.x() + cos * way.y());
	}

	private static double spread(final List<Point> all) {
		final Point middle = RobustStatistics.upperMedian(all);
		return RobustStatistics
			.median(all.stream().mapToDouble(p -> p.distanceTo(middle)).toArray());
	}
}
