package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.AppearanceFinder;
import io.github.knotresolver.skeleton.EvidenceFinder;
import io.github.knotresolver.track.FrameView;

/** Our way from pixels to graphs: by evidence, with nothing told. */
final class EvidencePreparer {

	/**
	 * Bytes that looking at a frame takes at a time: for each of its pixels in each thread, and
	 * for each in the frames that tell what lines look like.
	 */
	private static final int BYTES_A_THREAD = 80, BYTES_ONCE = 16;

	private static final int MEGABYTE = 1 << 20;

	private final Movie movie;
	private final Polarity polarity;
	private final Workers workers;
	private final Progress progress;

	EvidencePreparer(final Movie movie, final Polarity polarity, final Workers workers,
		final Progress progress) {
		this.movie = movie;
		this.polarity = polarity;
		this.workers = workers;
		this.progress = progress;
	}

	/** @param frames 1-based numbers of the frames, in order */
	PreparedMovie prepare(final List<Integer> frames, final List<Point> told) {
		final Workers threads = inMemory();
		final AppearanceFinder looks = new AppearanceFinder(threads, progress);
		final StillSpots spotless = StillSpots.off(movie, frames,
			looks.find(movie, frames, polarity), m -> looks.find(m, frames, polarity));
		final AppearanceFinder.Found found = spotless.lines();
		final List<String> notes = new ArrayList<>(EvidenceNotes.early(found));
		notes.addAll(EvidenceNotes.of(spotless));
		notes.forEach(progress::note);
		final EvidenceFinder finder = new EvidenceFinder(found.appearance());
		final List<FrameEvidence> evidence = threads.map("Finding lines", progress, frames.size(),
			t -> finder.find(spotless.movie().frame(frames.get(t) - 1)));
		final WorkingPixels blocks = new WorkingPixels(found.appearance().binning(), 0, 0);
		final Box box = Box.around(evidence, told.stream().map(blocks::in).toList(),
			SessionTuning.BOX_MARGIN);
		final FrameLights lights = new FrameLights(spotless.movie(), box,
			Runtime.getRuntime().maxMemory());
		final List<FrameView> views = workers.map("Thinning", progress, frames.size(), t -> {
			final FrameEvidence part = evidence.get(t).part(box.x(), box.y(), box.width(),
				box.height());
			return new FrameView(frames.get(t), lights.of(frames.get(t), part), part);
		});
		final List<FrameView> lit = new BlankFrames(views).lit();
		final List<Observation> lost = new ArrayList<>();
		for (final FrameView view : views)
			if (!lit.contains(view))
				lost.add(Observation.without(view.frame(), FrameStatus.LOST,
					"This frame is blank, dark or bright throughout, where the filament is in those around it."));
		final WorkingPixels pixels = new WorkingPixels(blocks.binning(), box.x(), box.y());
		final Clipping clipping = Clipping.along(movie, lit, pixels);
		final List<String> late = EvidenceNotes.late(lit, lost.size(), clipping);
		late.forEach(progress::note);
		notes.addAll(late);
		return new PreparedMovie(clipping.isClipped()
			? workers.map(lit.size(), t -> lights.withCeiling(lit.get(t), movie, clipping))
			: lit, pixels, lost, clipping.kinds(), notes);
	}

	/** As many threads as find room in Java's memory, all or one. */
	private Workers inMemory() {
		final double pixels = (double) movie.width() * movie.height();
		final long memory = Runtime.getRuntime().maxMemory();
		if (pixels * (BYTES_ONCE + BYTES_A_THREAD * workers.threads()) <= memory)
			return workers;
		final double needed = pixels * (BYTES_ONCE + BYTES_A_THREAD);
		if (needed > memory)
			throw new UserException("There is not enough memory for frames of " + movie.width()
				+ " x " + movie.height() + " pixels: they need "
				+ (long) Math.ceil(needed / MEGABYTE) + " MB, and Java has " + memory / MEGABYTE
				+ " MB; give Java more (JAVA_OPTS=-Xmx8g, in ImageJ Edit > Options > Memory & Threads), or name a region.",
				new OutOfMemoryError());
		return Workers.HERE;
	}
}
