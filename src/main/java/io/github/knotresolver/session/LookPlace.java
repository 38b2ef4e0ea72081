package io.github.knotresolver.session;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.SceneTrails;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.geometry.GaussianSmoothing;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.ConnectedComponents;
import io.github.knotresolver.mask.ConnectedComponents.MaskObject;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.FilamentChoice;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.skeleton.Skeletonize;

/** Makes of a frame's mask and skeleton what a person sees of them, in the movie's pixels. */
record LookPlace(Movie movie, WorkingPixels pixels) {

	/** What is known of the movie's lines; the settings in working pixels. */
	record Lines(Settings settings, Polarity polarity, OptionalDouble width) {
	}

	/** What the graph suggests, in working pixels, and how many ends lie on strands. */
	private record Courses(List<Polyline> curves, int hiddenEnds) {
	}

	FrameLook look(final int frame, final Img<BitType> mask, final Img<BitType> skeleton,
		final Lines lines, final Progress progress) {
		final Courses courses = courses(frame, SkeletonGraph.of(skeleton), lines, progress);
		final Img<BitType> whole = enlarged(mask);
		final List<MaskObject> objects = ConnectedComponents.of(mask).objects();
		return new FrameLook(frame, whole,
			pixels.binning() == 1 ? skeleton : Skeletonize.thin(enlarged(skeleton)), objects.size(),
			objects.stream().mapToInt(MaskObject::pixels).sum() * pixels.binning()
				* pixels.binning(),
			courses.curves.stream().map(pixels::out).toList(), courses.hiddenEnds, lines.polarity,
			lines.width);
	}

	private Courses courses(final int frame, final SkeletonGraph graph, final Lines lines,
		final Progress progress) {
		final Optional<Point> end = lines.settings.fixedEnd();
		if (end.isPresent() && lines.settings.filaments() != FilamentChoice.ALL) {
			final List<Candidate> best = TrailCandidates.DEFAULT
				.generate(CandidateQuery.of(graph, end.get(), lines.settings.length()), progress)
				.candidates();
			return best.isEmpty()
				? new Courses(List.of(), 0)
				: alone(ContourBuilder.smooth(best.get(0)), graph);
		}
		final SceneTrails.Found found = SceneTrails.of(graph,
			brightness(frame, graph, lines.polarity));
		final List<Polyline> curves = found.curves().stream().map(LookPlace::smooth)
			.filter(c -> c.length() >= SessionTuning.LOOK_SHORTEST)
			.sorted(Comparator.comparingDouble(Polyline::length).reversed()).toList();
		return lines.settings.deliversAll() || curves.isEmpty()
			? new Courses(curves, found.loose())
			: new Courses(curves.subList(0, 1), Math.min(2, found.loose()));
	}

	private static Courses alone(final Polyline contour, final SkeletonGraph graph) {
		final boolean open = graph.freeEnds().stream()
			.anyMatch(n -> n.position().distanceTo(contour.last()) <= SessionTuning.LOOK_OPEN);
		return new Courses(List.of(contour), open ? 0 : 1);
	}

	private static Polyline smooth(final Polyline trail) {
		final Polyline even = trail.resampled(1);
		return even.size() > 2
			? GaussianSmoothing.gaussian(even, SessionTuning.LOOK_SMOOTH).resampled(1)
			: even;
	}

	/** The light of a curve in units of that of the skeleton's usual pixel. */
	private ToDoubleFunction<Polyline> brightness(final int frame, final SkeletonGraph graph,
		final Polarity polarity) {
		final float[] grey = Pixels.floats(movie.frame(frame - 1));
		final float[] sorted = grey.clone();
		Arrays.sort(sorted);
		final double dark = sorted[sorted.length / 2];
		final ToDoubleFunction<Polyline> light = c -> median(c,
			p -> (polarity == Polarity.DARK ? -1 : 1)
				* (Pixels.between(grey, movie.width(), p.x(), p.y()) - dark));
		final double usual = graph.segments().stream().map(s -> s.curve())
			.max(Comparator.comparingDouble(Polyline::length)).map(light::applyAsDouble)
			.orElse(1.0);
		return usual > 0 ? c -> light.applyAsDouble(c) / usual : c -> 1;
	}

	private double median(final Polyline curve, final ToDoubleFunction<Point> value) {
		final double[] values = new double[curve.size()];
		for (int i = 0; i < values.length; i++)
			values[i] = value.applyAsDouble(pixels.out(curve.point(i)));
		return RobustStatistics.upperMedian(values, 0);
	}

	private Img<BitType> enlarged(final Img<BitType> mask) {
		final int factor = pixels.binning();
		if (factor == 1)
			return mask;
		final boolean[] small = Pixels.bits(mask);
		final int columns = Pixels.width(mask);
		final boolean[] large = new boolean[movie.width() * movie.height()];
		for (int y = 0; y < Pixels.height(mask) * factor; y++)
			for (int x = 0; x < columns * factor; x++)
				large[y * movie.width() + x] = small[y / factor * columns + x / factor];
		return Pixels.mask(large, movie.width());
	}

	/** A look at a part of the movie, as one of the whole. */
	static FrameLook back(final Region region, final Movie whole, final FrameLook part) {
		return new FrameLook(part.frame(), back(region, whole, part.mask()),
			back(region, whole, part.skeleton()), part.objects(), part.area(),
			part.contours().stream().map(region::back).toList(), part.hiddenEnds(), part.polarity(),
			part.width());
	}

	private static Img<BitType> back(final Region region, final Movie whole,
		final Img<BitType> part) {
		final boolean[] small = Pixels.bits(part);
		final boolean[] large = new boolean[whole.width() * whole.height()];
		for (int row = 0; row < region.height(); row++)
			System.arraycopy(small, row * region.width(), large,
				(region.y() + row) * whole.width() + region.x(), region.width());
		return Pixels.mask(large, whole.width());
	}
}
