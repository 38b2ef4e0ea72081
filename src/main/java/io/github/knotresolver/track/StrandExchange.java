package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.GaussianSmoothing;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * Two strands of one filament that lie on each other at two places and apart in between: at
 * each place they cross or they only touch, and the light hardly tells. Here are the contours on
 * which they are exchanged between two such places.
 */
final class StrandExchange {

	private final Polyline nodes;
	private final double width;
	private final double link;

	/**
	 * @param chain the filament
	 * @param width of its line in pixels, at half maximum
	 */
	StrandExchange(final Chain chain, final double width) {
		nodes = chain.polyline();
		this.width = width;
		link = chain.linkLength();
	}

	/** A place where two strands lie on each other: nodes of the earlier and of the later one. */
	private record Contact(int i, int j) {
	}

	/** @return the contours that differ visibly, those with the shortest exchanged part first */
	List<Polyline> contours() {
		final List<Contact> contacts = contacts();
		final List<int[]> pairs = new ArrayList<>();
		for (int a = 0; a < contacts.size(); a++)
			for (int b = 0; b < contacts.size(); b++)
				if (exchangeable(contacts.get(a), contacts.get(b)))
					pairs.add(new int[]{a, b});
		pairs.sort(Comparator.comparingInt(p -> contacts.get(p[1]).i - contacts.get(p[0]).i));
		return pairs.stream().limit(TrackTuning.EXCHANGES)
			.map(p -> exchanged(contacts.get(p[0]), contacts.get(p[1]))).toList();
	}

	/** Where the distance of two nodes that are far apart along the filament is smallest. */
	private List<Contact> contacts() {
		final int apart = (int) Math.ceil(TrackTuning.STRANDS_APART * width / link);
		final List<Contact> contacts = new ArrayList<>();
		for (int i = 0; i < nodes.size(); i++)
			for (int j = i + apart; j < nodes.size(); j++)
				if (distance(i, j) < width && isSmallest(i, j))
					contacts.add(new Contact(i, j));
		return contacts;
	}

	private boolean isSmallest(final int i, final int j) {
		final double here = distance(i, j);
		for (int di = -1; di <= 1; di++)
			for (int dj = -1; dj <= 1; dj++)
				if (i + di >= 0 && i + di <= j + dj && j + dj < nodes.size()
					&& distance(i + di, j + dj) < here)
					return false;
		return true;
	}

	private double distance(final int i, final int j) {
		return Math.hypot(nodes.x(i) - nodes.x(j), nodes.y(i) - nodes.y(j));
	}

	/** Whether both strands go from one contact to the other, nearly equally far, and apart. */
	private boolean exchangeable(final Contact a, final Contact b) {
		final int first = b.i - a.i, second = Math.abs(b.j - a.j);
		if (first < 2 || second < 2 || b.i >= Math.min(a.j, b.j)
			|| Math.abs(first - second) * link > width + TrackTuning.STRANDS_ALIKE * first * link)
			return false;
		double most = 0;
		for (int k = 0; k <= first; k++)
			most = Math.max(most,
				distance(a.i + k, a.j + (int) Math.rint((double) k * (b.j - a.j) / first)));
		return most > TrackTuning.STRANDS_SEEN * width && most < TrackTuning.STRANDS_NEAR * width;
	}

	private Polyline exchanged(final Contact a, final Contact b) {
		final List<Point> points = new ArrayList<>();
		add(points, 0, a.i - 1);
		add(points, a.j, b.j);
		if (a.j < b.j) {
			add(points, b.i + 1, a.j - 1);
			add(points, a.i, b.i);
			add(points, b.j + 1, nodes.size() - 1);
		} else {
			add(points, b.i + 1, b.j - 1);
			add(points, b.i, a.i);
			add(points, a.j + 1, nodes.size() - 1);
		}
		final Polyline even = Polyline.of(points).resampled(1);
		return even.size() > 2
			? GaussianSmoothing.gaussian(even, TrackTuning.STRANDS_SMOOTH)
			: even;
	}

	/** Adds nodes from one to another, both included, in this order; none if it is not there. */
	private void add(final List<Point> points, final int from, final int to) {
		final boolean tail = to == nodes.size() - 1 && from == nodes.size();
		final boolean head = from == 0 && to < 0;
		if (tail || head)
			return;
		final int step = from <= to ? 1 : -1;
		for (int k = from; k != to + step; k += step)
			points.add(nodes.point(k));
	}
}
