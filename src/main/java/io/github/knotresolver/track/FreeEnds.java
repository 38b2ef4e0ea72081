package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;

import net.imglib2.Cursor;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import org.jgrapht.alg.connectivity.ConnectivityInspector;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.track.EndPaths.End;

/**
 * The free ends of all skeletons of a movie. Each votes with the length of its object, as
 * far as that lies where there is no mask in most frames: what moves counts fully, what
 * lies still (debris, a stuck filament) hardly. An end at the border is an end of the
 * picture, not of a filament, and counts for little.
 */
final class FreeEnds {

	private final List<FrameView> frames;
	private final double[] covered;

	private FreeEnds(final List<FrameView> frames) {
		this.frames = frames;
		covered = coverage();
	}

	/**
	 * @param frames the movie, at least one frame
	 * @return their ends, in order of time
	 */
	static List<End> of(final List<FrameView> frames) {
		final FreeEnds finder = new FreeEnds(frames);
		final List<End> ends = new ArrayList<>();
		for (int t = 0; t < frames.size(); t++)
			finder.add(t, ends);
		return ends;
	}

	/**
	 * @param frame a frame
	 * @param place in pixels
	 * @return whether the place is so near the border that what ends there may go on outside
	 */
	static boolean atBorder(final FrameView frame, final Point place) {
		return place.x() < TrackTuning.BORDER || place.y() < TrackTuning.BORDER
			|| place.x() > frame.light().width() - 1 - TrackTuning.BORDER
			|| place.y() > frame.light().height() - 1 - TrackTuning.BORDER;
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

	private void add(final int t, final List<End> ends) {
		final FrameView frame = frames.get(t);
		final SkeletonGraph graph = frame.graph();
		final ConnectivityInspector<Node, Segment> parts = new ConnectivityInspector<>(
			graph.asGraph());
		for (final Set<Node> part : parts.connectedSets()) {
			final List<Segment> segments = graph.segments().stream()
				.filter(s -> part.contains(s.source())).toList();
			final double length = segments.stream().mapToDouble(Segment::length).sum();
			if (length < TrackTuning.SPECK)
				continue;
			final double vote = segments.stream().mapToDouble(this::moving).sum()
				+ TrackTuning.STILL_VOTE * length;
			part.stream().filter(Node::isFreeEnd).sorted(Comparator.comparingInt(Node::id))
				.forEach(n -> ends.add(new End(t, n.position(), outward(n, segments),
					atBorder(frame, n.position()) ? TrackTuning.AT_BORDER * vote : vote)));
		}
	}

	/** The direction in which a segment ends at a free end. */
	private static double outward(final Node end, final List<Segment> segments) {
		for (final Segment s : segments) {
			final Polyline curve = s.curve();
			final double back = Math.min(TrackTuning.END_DIRECTION, curve.length());
			if (s.source().id() == end.id())
				return direction(curve.at(back), end.position());
			if (s.target().id() == end.id())
				return direction(curve.at(curve.length() - back), end.position());
		}
		return 0;
	}

	private static double direction(final Point from, final Point to) {
		return Math.atan2(to.y() - from.y(), to.x() - from.x());
	}

	/** How much of a segment lies where there is no mask in most frames. */
	private double moving(final Segment segment) {
		final int width = (int) frames.get(0).mask().dimension(0);
		double sum = 0;
		for (int i = 0; i < segment.curve().size(); i++) {
			final int at = (int) Math.rint(segment.curve().y(i)) * width
				+ (int) Math.rint(segment.curve().x(i));
			sum += Math.max(0, 1 - covered[at]);
		}
		return sum / segment.curve().size() * segment.length();
	}
}
