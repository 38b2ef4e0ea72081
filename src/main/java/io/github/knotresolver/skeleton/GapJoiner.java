package io.github.knotresolver.skeleton;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

import io.github.knotresolver.image.Ridges;

/** Joins free ends that face each other across a gap with some light in it. */
final class GapJoiner {

	private final Ridges ridges;
	private final double reach;

	GapJoiner(final Ridges ridges) {
		this.ridges = ridges;
		reach = SkeletonTuning.GAP_REACH * ridges.appearance().workingSigma();
	}

	private record End(int at, int x, int y, double dx, double dy) {
	}

	private record Gap(double width, End a, End b) {
	}

	/** Draws the joints, the shortest first, one at each end. O(ends²) at worst for ends in one column. */
	void join(final LinePixels line) {
		final List<Gap> gaps = gaps(ends(line));
		gaps.sort(Comparator.comparingDouble(Gap::width).thenComparingInt(g -> g.a.at)
			.thenComparingInt(g -> g.b.at));
		final Set<End> used = new HashSet<>();
		for (final Gap gap : gaps)
			if (!used.contains(gap.a) && !used.contains(gap.b) && isLit(gap)) {
				line.draw(gap.a.at, gap.b.at);
				used.add(gap.a);
				used.add(gap.b);
			}
		if (!used.isEmpty())
			line.thin();
	}

	private List<End> ends(final LinePixels line) {
		final List<End> ends = new ArrayList<>();
		for (final int at : line.ends()) {
			final int[] path = line.walk(at, SkeletonTuning.GAP_DIRECTION);
			final int x = line.inside(at) % line.width(), y = line.inside(at) / line.width();
			double dx = 0, dy = 0;
			for (final int p : path) {
				dx += x - line.inside(p) % line.width();
				dy += y - line.inside(p) / line.width();
			}
			final double norm = Math.hypot(dx, dy) + 1e-9;
			ends.add(new End(at, x, y, dx / norm, dy / norm));
		}
		ends.sort(Comparator.comparingInt(End::x).thenComparingInt(End::y));
		return ends;
	}

	private List<Gap> gaps(final List<End> ends) {
		final List<Gap> gaps = new ArrayList<>();
		for (int i = 0; i < ends.size(); i++)
			for (int j = i + 1; j < ends.size() && ends.get(j).x - ends.get(i).x < reach; j++) {
				final End a = ends.get(i), b = ends.get(j);
				final double dx = b.x - a.x, dy = b.y - a.y, d = Math.hypot(dx, dy);
				if (d > SkeletonTuning.TOUCHING && d < reach
					&& a.dx * dx + a.dy * dy > SkeletonTuning.FACING * d
					&& -b.dx * dx - b.dy * dy > SkeletonTuning.FACING * d)
					gaps.add(new Gap(d, a, b));
			}
		return gaps;
	}

	private boolean isLit(final Gap gap) {
		final int steps = (int) Math.ceil(gap.width);
		final int[] places = new int[steps + 1];
		for (int i = 0; i <= steps; i++)
			places[i] = (int) Math.rint(gap.a.y + (double) i * (gap.b.y - gap.a.y) / steps)
				* ridges.width()
				+ (int) Math.rint(gap.a.x + (double) i * (gap.b.x - gap.a.x) / steps);
		return Surety.of(places, ridges) > SkeletonTuning.SURE_GAP;
	}
}
