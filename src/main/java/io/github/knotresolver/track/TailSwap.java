
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.GaussianSmoothing;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.track.PairFit.Two;

/**
 * Two filaments that touch may have been given each other's tails: where light is missing,
 * the exchange is tried at every place where they are near, if both lengths allow it. Kept
 * if both together become cheaper.
 */
final class TailSwap {

	/** So often two take turns. */
	private static final int ROUNDS = 2;

	private final Scene scene;
	private final FitSettings settings;
	private final List<Chain> expected;
	private final double mismatch;

	/**
	 * @param scene a frame with all its chains drawn
	 * @param settings weights
	 * @param expected the shapes that the chains are expected to have
	 * @param mismatch light that is missing or too much, in strands, from which on a chain is
	 *          looked at
	 */
	TailSwap(final Scene scene, final FitSettings settings, final List<Chain> expected,
		final double mismatch) {
		this.scene = scene;
		this.settings = settings;
		this.expected = expected;
		this.mismatch = mismatch;
	}

	/**
	 * Exchanges tails wherever that is better.
	 *
	 * @param worthIt the chains that are worth it; of a pair, one must be
	 */
	void mend(final boolean[] worthIt) {
		final boolean[] wrong = new boolean[worthIt.length];
		for (int k = 0; k < wrong.length; k++)
			wrong[k] = worthIt[k] && scene.isOff(scene.chain(k), mismatch);
		for (int i = 0; i < wrong.length; i++)
			for (int j = 0; j < i; j++)
				if ((wrong[i] || wrong[j]) && scene.mayTouch(i, j))
					mend(i, j);
	}

	private void mend(final int i, final int j) {
		final Chain a = scene.chain(i), b = scene.chain(j);
		final List<Two> exchanged = exchanged(a, b, SceneTuning.SWAP_LENGTH);
		if (exchanged.isEmpty())
			return;
		scene.take(i);
		scene.take(j);
		final PairFit pair = new PairFit(scene, i, j, settings, ROUNDS);
		final double before = energy(pair, i, j, new Two(a, b, Double.NaN));
		Two best = null;
		for (final Two p : exchanged) {
			final double energy = energy(pair, i, j, p);
			if (best == null || energy < best.price())
				best = new Two(p.a(), p.b(), energy);
		}
		Two fitted = best;
		for (int round = 0; round < ROUNDS; round++)
			fitted = pair.swept(fitted);
		final boolean better = energy(pair, i, j, fitted) < before - SceneTuning.SWAP_BETTER;
		scene.put(i, better ? fitted.a() : a);
		scene.put(j, better ? fitted.b() : b);
	}

	/** What two chains cost together, leaving what was expected included. */
	private double energy(final PairFit pair, final int i, final int j, final Two two) {
		return pair.price(two.a(), two.b()) + memory(two.a(), expected.get(i))
			+ memory(two.b(), expected.get(j));
	}

	private double memory(final Chain chain, final Chain from) {
		return settings.memory() * chain.length() * chain.squaredTurn(from);
	}

	/**
	 * All exchanges that both lengths allow, not priced.
	 *
	 * @param tolerance by so much (pixels) lengths may be off
	 */
	static List<Two> exchanged(final Chain a, final Chain b, final double tolerance) {
		final List<Two> all = new ArrayList<>();
		for (final int[] nodes : touches(a.polyline(), b.polyline()))
			exchange(a, b, nodes, tolerance, all);
		return all;
	}

	/** Nodes in the middle of each stretch on which two curves touch. */
	private static List<int[]> touches(final Polyline p, final Polyline q) {
		final List<int[]> places = new ArrayList<>();
		int from = -1;
		for (int i = 0; i <= p.size(); i++) {
			final boolean near = i < p.size() && squared(p, i, q,
				nearest(p, i, q)) < SceneTuning.SWAP_TOUCH * SceneTuning.SWAP_TOUCH;
			if (near && from < 0)
				from = i;
			if (!near && from >= 0) {
				final int middle = (from + i - 1) / 2;
				places.add(new int[]{middle, nearest(p, middle, q)});
				from = -1;
			}
		}
		return places;
	}

	/** The same, and all exchanges at places where they cross, of which a long touch has several. */
	static List<Two> everywhere(final Chain a, final Chain b, final double tolerance) {
		final List<Two> all = exchanged(a, b, tolerance);
		for (final int[] nodes : crossings(a.polyline(), b.polyline()))
			exchange(a, b, nodes, tolerance, all);
		return all;
	}

	/**
	 * What two filaments are that exchange what is behind a place where they touch or cross, each as
	 * long as it then is; not priced.
	 */
	static List<Two> ofAnyLength(final Chain a, final Chain b) {
		final Polyline p = a.polyline(), q = b.polyline();
		final List<int[]> places = touches(p, q);
		places.addAll(crossings(p, q));
		final List<Two> all = new ArrayList<>();
		for (final int[] nodes : places)
			for (final List<List<Point>> curves : curves(a, b, nodes))
				if (curves.stream().allMatch(c -> c.size() >= SceneTuning.SWAP_NODES))
					all.add(new Two(whole(curves.get(0)), whole(curves.get(1)), Double.NaN));
		return all;
	}

	private static Chain whole(final List<Point> points) {
		final Polyline curve = Polyline.of(points);
		return Chain.inScene(curve, curve.length());
	}

	/** Nodes at which two curves cross. */
	private static List<int[]> crossings(final Polyline p, final Polyline q) {
		final List<int[]> places = new ArrayList<>();
		for (int i = 0; i + 1 < p.size(); i++)
			for (int k = 0; k + 1 < q.size(); k++)
				if (cross(p, i, q, k))
					places.add(new int[]{i + 1, k + 1});
		return places;
	}

	/** Whether the i-th link of one crosses the k-th of the other. */
	private static boolean cross(final Polyline p, final int i, final Polyline q, final int k) {
		return side(p, i, q.point(k)) * side(p, i, q.point(k + 1)) < 0
			&& side(q, k, p.point(i)) * side(q, k, p.point(i + 1)) < 0;
	}

	private static double side(final Polyline curve, final int link, final Point point) {
		final Point from = curve.point(link), to = curve.point(link + 1);
		return (to.x() - from.x()) * (point.y() - from.y())
			- (to.y() - from.y()) * (point.x() - from.x());
	}

	private static int nearest(final Polyline p, final int i, final Polyline q) {
		int best = 0;
		for (int k = 1; k < q.size(); k++)
			if (squared(p, i, q, k) < squared(p, i, q, best))
				best = k;
		return best;
	}

	private static double squared(final Polyline p, final int i, final Polyline q, final int k) {
		final double dx = p.x(i) - q.x(k), dy = p.y(i) - q.y(k);
		return dx * dx + dy * dy;
	}

	/** Exchanges what is behind a node of each. */
	private static void exchange(final Chain a, final Chain b, final int[] nodes,
		final double tolerance, final List<Two> all) {
		for (final List<List<Point>> curves : curves(a, b, nodes))
			all.addAll(pairs(a, b, curves, tolerance));
	}

	/** Both exchanges at a node of each: of what is behind it, and of what is behind one of them. */
	private static List<List<List<Point>>> curves(final Chain a, final Chain b, final int[] nodes) {
		final int i = nodes[0], j = nodes[1];
		final List<Point> p = points(a), q = points(b);
		final List<Point> headA = p.subList(0, i), tailA = p.subList(i, p.size());
		final List<Point> headB = q.subList(0, j), tailB = q.subList(j, q.size());
		return List.of(List.of(joined(headA, tailB), joined(headB, tailA)),
			List.of(joined(headA, reversed(headB)), joined(reversed(tailA), tailB)));
	}

	/** Two curves as the two filaments, in both ways. */
	private static List<Two> pairs(final Chain a, final Chain b, final List<List<Point>> curves,
		final double tolerance) {
		final List<Two> pairs = new ArrayList<>();
		if (curves.stream().allMatch(c -> c.size() >= SceneTuning.SWAP_NODES))
			for (int one = 0; one < 2; one++) {
				final Optional<Chain> first = as(a, curves.get(one), tolerance);
				final Optional<Chain> second = as(b, curves.get(1 - one), tolerance);
				if (first.isPresent() && second.isPresent())
					pairs.add(new Two(first.get(), second.get(), Double.NaN));
			}
		return pairs;
	}

	/** A curve as the chain of a filament, that runs as it did; empty if it cannot be. */
	private static Optional<Chain> as(final Chain filament, final List<Point> points,
		final double tolerance) {
		Polyline curve = Polyline.of(points);
		if (Math.abs(curve.length() - filament.length()) > tolerance)
			return Optional.empty();
		if (curve.first().distanceTo(filament.start()) > curve.last().distanceTo(filament.start()))
			curve = curve.reversed();
		if (curve.first().distanceTo(filament.start()) > SceneTuning.SWAP_JUMP)
			return Optional.empty();
		final Polyline even = curve.resampled(1);
		final Polyline smooth = even.size() > 2
			? GaussianSmoothing.gaussian(even, SceneTuning.SWAP_SMOOTH)
			: even;
		final double missing = filament.length() - smooth.length();
		final Polyline whole = missing > 0
			? UnexplainedLight.extended(smooth, missing)
			: smooth.head(filament.length());
		return Optional.of(Chain.along(whole, filament.links(), filament.length()));
	}

	private static List<Point> points(final Chain chain) {
		final Polyline curve = chain.polyline();
		final List<Point> points = new ArrayList<>();
		for (int i = 0; i < curve.size(); i++)
			points.add(curve.point(i));
		return points;
	}

	private static List<Point> reversed(final List<Point> points) {
		final List<Point> back = new ArrayList<>(points);
		Collections.reverse(back);
		return back;
	}

	private static List<Point> joined(final List<Point> a, final List<Point> b) {
		final List<Point> all = new ArrayList<>(a);
		all.addAll(b);
		return all;
	}
}
