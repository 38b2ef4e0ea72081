package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.Background;
import io.github.knotresolver.image.Binning;
import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.Dilation;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.AppearanceFinder;
import io.github.knotresolver.skeleton.EvidenceFinder;
import io.github.knotresolver.track.FrameView;

/** Our way from pixels to graphs: by evidence, with nothing told. */
final class EvidencePreparer {

	/** Light reaches this many standard deviations of the line beyond its mask. */
	private static final double HALO = 3;

	/** Pixels around what was found that are kept. */
	private static final int MARGIN = 24;

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
		final AppearanceFinder.Found found = new AppearanceFinder(workers, progress).find(movie,
			frames, polarity);
		final List<String> notes = new ArrayList<>(EvidenceNotes.early(found));
		notes.forEach(progress::note);
		final EvidenceFinder finder = new EvidenceFinder(found.appearance());
		final List<FrameEvidence> evidence = workers.map("Finding lines", progress, frames.size(),
			t -> finder.find(movie.frame(frames.get(t) - 1)));
		final WorkingPixels blocks = new WorkingPixels(found.appearance().binning(), 0, 0);
		final Box box = Box.around(evidence, told.stream().map(blocks::in).toList(), MARGIN);
		final List<FrameView> views = workers.map("Thinning", progress, frames.size(),
			t -> view(frames.get(t), evidence.get(t), box));
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
		return new PreparedMovie(
			clipping.isClipped()
				? workers.map(lit.size(), t -> withCeiling(lit.get(t), box, clipping))
				: lit,
			pixels, lost, clipping.kinds(), notes);
	}

	/**
	 * The frame, of which it is known above what brightness it does not say more: less its
	 * noise, since noise is cut off, too.
	 */
	private FrameView withCeiling(final FrameView view, final Box box, final Clipping clipping) {
		final LineAppearance a = view.evidence().orElseThrow().appearance();
		final double noise = view.light().noise();
		final float[] part = box.of(binned(view.frame(), a.binning()),
			movie.width() / a.binning());
		final double[] ceiling = new double[part.length];
		for (int i = 0; i < ceiling.length; i++)
			// Light is the pixel above its background.
			ceiling[i] = Float.isFinite(part[i])
				? clipping.ceiling() - a.polarity().sign() * part[i] + view.light().pixels()[i]
					- noise
				: Double.POSITIVE_INFINITY;
		return view.withCeiling(ceiling);
	}

	private float[] binned(final int frame, final int binning) {
		final double[] values = Pixels.doubles(movie.frame(frame - 1));
		final float[] pixels = new float[values.length];
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = (float) values[i];
		return Binning.mean(pixels, movie.width(), binning);
	}

	private FrameView view(final int frame, final FrameEvidence whole, final Box box) {
		final FrameEvidence evidence = whole.part(box.x(), box.y(), box.width(), box.height());
		return new FrameView(frame, light(frame, evidence, box), evidence);
	}

	/** The frame above its background, bright lines whatever the polarity. */
	private NormalizedFrame light(final int frame, final FrameEvidence evidence, final Box box) {
		final LineAppearance a = evidence.appearance();
		final float[] part = box.of(binned(frame, a.binning()), movie.width() / a.binning());
		final boolean[] lines = Dilation.square(Pixels.bits(evidence.mask()), evidence.width(),
			(int) Math.ceil(HALO * a.workingSigma()));
		final float[] background = Background.of(part, box.width(), lines);
		final double[] light = new double[part.length];
		for (int i = 0; i < light.length; i++)
			light[i] = Float.isFinite(part[i])
				? a.polarity().sign() * (part[i] - background[i])
				: 0;
		return new NormalizedFrame(box.width(), box.height(), light);
	}
}
