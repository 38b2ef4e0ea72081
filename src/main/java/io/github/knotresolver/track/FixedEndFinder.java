package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

import net.imglib2.Cursor;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import org.jgrapht.alg.connectivity.ConnectivityInspector;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.progress.Progress;

/**
 * Finds the clamped end without being told: a free end of the skeleton that
 * stays in place over the movie, of an object that is long and moves. Debris that
 * sticks to the filament has ends that stay, too; among such places the one wins
 * from which trails explain the skeletons most cheaply.
 */
public final class FixedEndFinder {

	/** Ends within this distance (pixels) are the same place. */
	private static final double SAME_PLACE = 4;

	/** Objects with less skeleton (pixels) are specks. */
	private static final double SHORTEST = 15;

	/** A place needs this share of the best place's votes to be looked at. */
	private static final double CONTENDER = 0.4;

	/** Price (pixels) of a place without any votes. */
	private static final double FEWER_VOTES = 20;

	/** Price of a frame in which no trail begins at a place; of one far from the filament, at most. */
	private static final double NO_TRAIL = 100;

	/** The clamped end is this near (pixels) to a skeleton in every frame. */
	private static final double NEAR = 6;

	private static final int CONTENDERS = 5;
	private static final int FRAMES_TO_TRY = 12;
	private static final TrailCandidates TRAILS = new TrailCandidates(3, 200, 2,
		TrailCandidates.DEFAULT.prices());

	private final List<FrameView> frames;
	private final Progress progress;

	/**
	 * @param frames the movie
	 * @param progress asked whether to stop
	 */
	public FixedEndFinder(final List<FrameView> frames, final Progress progress) {
		this.frames = frames;
		this.progress = progress;
	}

	/** A free end in one frame, and how much its object looks like the filament. */
	private record End(int frame, Point at, double vote) {
	}

	/** Ends of different frames at the same place. */
	private record Place(Point at, double votes, double spread) {
	}

	/** @return the fixed end in pixels; empty if no filament was found */
	public Optional<Point> find() {
		final double[] covered = coverage();
		final List<End> ends = new ArrayList<>();
		for (int t = 0; t < frames.size(); t++)
			addEnds(t, covered, ends);
		final List<Place> places = places(ends);
		if (places.size() < 2)
			return places.stream().map(Place::at).findFirst();
		final double most = places.get(0).votes;
		return places.stream()
			.min(Comparator.comparingDouble(p -> price(p) + FEWER_VOTES * (1 - p.votes / most)))
			.map(Place::at);
	}

	/** For every pixel, the share of frames in which the mask covers it. */
	private double[] coverage() {
		final Img<BitType> first = frames.get(0).mask();
		final double[] share = new double[(int) (first.dimension(0) * first.dimension(1))];
		for (final FrameView frame : frames) {
			final Cursor<BitType> cursor = frame.mask().cursor();
			for (int i = 0; i < share.length; i++)
				if (cursor.next().get())
					share[i] += 1.0 / frames.size();
		}
		return share;
	}

	private void addEnds(final int t, final double[] covered, final List<End> ends) {
		final SkeletonGraph graph = frames.get(t).graph();
		final ConnectivityInspector<Node, Segment> parts = new ConnectivityInspector<>(
			graph.asGraph());
		for (final Set<Node> part : parts.connectedSets()) {
			final List<Segment> segments = graph.segments().stream()
				.filter(s -> part.contains(s.source())).toList();
			final double moving = segments.stream().mapToDouble(s -> moving(s, covered)).sum();
			final double length = segments.stream().mapToDouble(Segment::length).sum();
			if (length < SHORTEST)
				continue;
			part.stream().filter(Node::isFreeEnd).sorted(Comparator.comparingInt(Node::id))
				.forEach(n -> ends.add(new End(t, n.position(), moving + 0.05 * length)));
		}
	}

	/** How much of a segment lies where there is no mask in most frames. */
	private double moving(final Segment segment, final double[] covered) {
		final int width = (int) frames.get(0).mask().dimension(0);
		double sum = 0;
		for (int i = 0; i < segment.curve().size(); i++) {
			final int at = (int) Math.rint(segment.curve().y(i)) * width
				+ (int) Math.rint(segment.curve().x(i));
			sum += Math.max(0, 1 - covered[at]);
		}
		return sum / segment.curve().size() * segment.length();
	}

	/** The places with the most votes, each frame voting once for a place. */
	private List<Place> places(final List<End> ends) {
		final List<Place> all = new ArrayList<>();
		for (final End end : ends) {
			progress.checkCancelled();
			all.add(place(end, ends));
		}
		all.sort(
			Comparator.comparingDouble(Place::votes).reversed().thenComparingDouble(Place::spread)
				.thenComparingDouble(p -> p.at.x()).thenComparingDouble(p -> p.at.y()));
		final List<Place> chosen = new ArrayList<>();
		for (final Place p : all) {
			if (chosen.size() == CONTENDERS || p.votes < CONTENDER * all.get(0).votes)
				break;
			if (chosen.stream().noneMatch(q -> q.at.distanceTo(p.at) < 2 * SAME_PLACE))
				chosen.add(p);
		}
		return chosen;
	}

	private static Place place(final End end, final List<End> ends) {
		final Set<Integer> voters = new HashSet<>();
		double votes = 0, spread = 0;
		for (final End other : ends) {
			final double d = other.at.distanceTo(end.at);
			if (d > SAME_PLACE || !voters.add(other.frame))
				continue;
			votes += other.vote;
			spread += d * other.vote;
		}
		return new Place(end.at, votes, spread / votes);
	}

	/** Mean price of the best trails from a place, and of its being away from any skeleton, in a sample of frames. */
	private double price(final Place place) {
		double sum = 0;
		final int tries = Math.min(FRAMES_TO_TRY, frames.size());
		for (int i = 0; i < tries; i++) {
			progress.checkCancelled();
			final FrameView frame = frames.get((int) ((i + 0.5) * frames.size() / tries));
			final List<Candidate> best = TRAILS
				.generate(CandidateQuery.of(frame.graph(), place.at, OptionalDouble.empty()),
					progress)
				.candidates();
			sum += best.isEmpty() ? NO_TRAIL : best.get(0).price().total();
			sum += Math.min(NO_TRAIL, Math.max(0, frame.distance(place.at) - NEAR));
		}
		return sum / tries;
	}
}
