package io.github.knotresolver.session;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.AppearanceFinder;
import io.github.knotresolver.skeleton.EvidenceFinder;
import io.github.knotresolver.skeleton.Skeletonize;
import io.github.knotresolver.track.FixedEndFinder;
import io.github.knotresolver.track.FrameView;

/**
 * Single frames of a movie as the program sees them before anything is resolved, for a person who
 * chooses values. What is known of the movie is kept from one question to the next, so that only the
 * frame itself is worked out anew. The masks are those that a run with the same settings would have,
 * with one exception: where the active contour goes on from frame to frame
 * ({@link Segmentation.Steps#ACTIVE_CONTOUR}), it starts in the frame that is looked at.
 * <p>
 * May be used by several threads; each waits for the other.
 */
public final class FramePreview {

	private final Movie movie;
	private final Map<Appearing, AppearanceFinder.Found> known = new HashMap<>();
	private final Map<Appearing, Bright> bright = new HashMap<>();
	private final Map<Region, FramePreview> parts = new HashMap<>();

	/** @param movie the movie; only read */
	public FramePreview(final Movie movie) {
		this.movie = movie;
	}

	/** What decides how a movie's lines appear. */
	private record Appearing(Polarity polarity, boolean published, List<Integer> frames) {

		static Appearing of(final Settings settings, final List<Integer> frames) {
			return new Appearing(settings.segmentation().polarity(), settings.isPublished(),
				frames);
		}
	}

	/**
	 * What a few frames say of a movie.
	 *
	 * @param notes what a user should know, one sentence each
	 * @param fixedEnd where the only filament is clamped, in pixels; empty if there are several, or none
	 */
	public record Check(List<String> notes, Optional<Point> fixedEnd) {

		public Check {
			notes = List.copyOf(notes);
		}
	}

	/**
	 * Looks at a frame. Linear in the number of pixels.
	 *
	 * @param settings how; what they say of how contours are resolved has no part in it
	 * @param frame 1-based number of a frame of the movie, chosen by the settings or not
	 * @param progress asked whether to stop
	 * @return what it shows
	 * @throws io.github.knotresolver.model.UserException if movie and settings do not fit together
	 */
	public synchronized FrameLook look(final Settings settings, final int frame,
		final Progress progress) {
		final List<Integer> wanted = new FrameChoice(movie, settings).frames();
		if (settings.region().isPresent()) {
			final Region region = settings.region().get().inside(movie);
			return LookPlace.back(region, movie,
				part(region).look(region.of(silent(settings)), frame, progress));
		}
		try (Workers workers = new Workers(settings.threads())) {
			return settings.segmentation().steps() == Segmentation.Steps.EVIDENCE
				? evidence(settings, wanted, frame, new Work(workers, progress))
				: threshold(settings, wanted, frame, new Work(workers, progress));
		}
	}

	private static Settings silent(final Settings settings) {
		return settings.edit().constraints(List.of()).build();
	}

	private FramePreview part(final Region region) {
		return parts.computeIfAbsent(region, r -> new FramePreview(r.of(movie)));
	}

	/** The movie with bright lines, and whether it is blurred before the threshold. */
	private record Bright(Movie lines, boolean blurs) {
	}

	private record Work(Workers workers, Progress progress) {
	}

	private FrameLook evidence(final Settings settings, final List<Integer> wanted, final int frame,
		final Work work) {
		final LineAppearance appearance = found(settings, wanted, work).appearance();
		work.progress.checkCancelled();
		final FrameEvidence evidence = new EvidenceFinder(appearance).find(movie.frame(frame - 1));
		work.progress.checkCancelled();
		final WorkingPixels pixels = new WorkingPixels(appearance.binning(), 0, 0);
		return new LookPlace(movie, pixels).look(frame, evidence.mask(), evidence.skeleton(),
			new LookPlace.Lines(pixels.of(silent(settings)), appearance.polarity(),
				OptionalDouble.of(appearance.width())),
			work.progress);
	}

	private AppearanceFinder.Found found(final Settings settings, final List<Integer> wanted,
		final Work work) {
		final Appearing key = Appearing.of(settings, wanted);
		if (!known.containsKey(key))
			known.put(key, new AppearanceFinder(work.workers, work.progress).find(movie, wanted,
				key.polarity));
		return known.get(key);
	}

	private FrameLook threshold(final Settings settings, final List<Integer> wanted,
		final int frame, final Work work) {
		final Bright movieOf = bright(settings, wanted, work);
		final Movie lines = movieOf.lines;
		final Img<BitType> mask = preparer(settings, movieOf)
			.masks(List.of(frame), work.workers, work.progress).get(0);
		work.progress.checkCancelled();
		return new LookPlace(lines, WorkingPixels.SAME).look(
			frame, mask, Skeletonize.thin(mask), new LookPlace.Lines(silent(settings),
				lines == movie ? Polarity.BRIGHT : Polarity.DARK, OptionalDouble.empty()),
			work.progress);
	}

	/**
	 * The frame as a threshold sees it: bright lines, stretched, without single noisy pixels.
	 *
	 * @param settings how; their steps have no part in it
	 * @param frame 1-based number of a frame of the movie
	 * @param progress asked whether to stop
	 * @return the whole frame, 0..1
	 */
	public synchronized Img<FloatType> clean(final Settings settings, final int frame,
		final Progress progress) {
		final List<Integer> wanted = new FrameChoice(movie, settings).frames();
		try (Workers workers = new Workers(settings.threads())) {
			return preparer(settings, bright(settings, wanted, new Work(workers, progress)))
				.clean(frame);
		}
	}

	private Bright bright(final Settings settings, final List<Integer> wanted, final Work work) {
		final Appearing key = Appearing.of(settings, wanted);
		if (!bright.containsKey(key)) {
			final Movie lines = PreparedMovie.bright(movie, settings, wanted, work.workers,
				work.progress);
			bright.put(key,
				new Bright(lines, !settings.isPublished() && FramePreparer.isNoisy(lines)));
		}
		return bright.get(key);
	}

	private static FramePreparer preparer(final Settings settings, final Bright of) {
		return new FramePreparer(of.lines, settings, of.blurs);
	}

	/**
	 * The check before the work, on a few frames of the movie: what a user should know of it.
	 *
	 * @param settings how it is to be resolved
	 * @param progress asked whether to stop
	 * @return what is to be known, one sentence each, and where the fixed end is if the movie shows one
	 *         clamped filament alone, as far as a few frames tell
	 * @throws io.github.knotresolver.model.UserException if movie and settings do not fit together
	 */
	public Check check(final Settings settings, final Progress progress) {
		final Movie part = settings.region().map(r -> r.of(movie)).orElse(movie);
		final Settings of = settings.region().map(r -> r.of(silent(settings)))
			.orElse(silent(settings));
		final List<Integer> few = few(new FrameChoice(movie, settings).frames());
		try (Workers workers = new Workers(1)) {
			final PreparedMovie prepared = PreparedMovie.of(part, of, few, workers, progress);
			return new Check(prepared.notes(), fixedEnd(prepared, progress)
				.map(end -> settings.region().map(r -> r.back(end)).orElse(end)));
		}
	}

	/**
	 * A quick guess whether there is one filament, clamped at one end, and where; the run itself looks
	 * at the whole movie.
	 */
	private static Optional<Point> fixedEnd(final PreparedMovie prepared, final Progress progress) {
		final List<FrameView> frames = prepared.frames();
		final long single = frames.stream().filter(f -> EvidenceNotes.objects(f) == 1).count();
		return single == 0 || single < SessionTuning.PREVIEW_SINGLE * frames.size()
			? Optional.empty()
			: new FixedEndFinder(frames, progress).find().filter(end -> isInPlace(end, frames))
				.map(prepared.pixels()::out);
	}

	private static boolean isInPlace(final Point end, final List<FrameView> frames) {
		return frames.stream()
			.filter(f -> f.graph().freeEnds().stream()
				.anyMatch(n -> n.position().distanceTo(end) <= SessionTuning.PREVIEW_END))
			.count() >= SessionTuning.PREVIEW_CLAMPED * frames.size();
	}

	private static List<Integer> few(final List<Integer> frames) {
		final int count = Math.min(SessionTuning.CHECKED, frames.size());
		return IntStream.range(0, count)
			.mapToObj(
				i -> frames.get((int) ((long) i * (frames.size() - 1) / Math.max(1, count - 1))))
			.distinct().toList();
	}
}
