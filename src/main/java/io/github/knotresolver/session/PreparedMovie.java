package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.converter.Converters;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.DoubleType;

import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.AppearanceFinder;
import io.github.knotresolver.track.FrameView;

/**
 * A movie on its way from pixels to graphs.
 *
 * @param frames the frames that show something, in order
 * @param pixels what their pixels are
 * @param lost the others: frames without light
 * @param kinds how strands may add up
 * @param notes what a user should know, one sentence each
 */
record PreparedMovie(List<FrameView> frames, WorkingPixels pixels, List<Observation> lost,
	Set<LineModel.Kind> kinds, List<String> notes) {

	/**
	 * Walks a movie from pixels to graphs, by the way that the parameters ask for.
	 *
	 * @param frames 1-based numbers of the frames, in order
	 */
	static PreparedMovie of(final Movie movie, final Settings parameters,
		final List<Integer> frames, final Workers workers, final Progress progress) {
		final Polarity polarity = parameters.segmentation().polarity();
		if (parameters.segmentation().steps() == Segmentation.Steps.EVIDENCE)
			return new EvidencePreparer(movie, polarity, workers, progress).prepare(frames,
				parameters.fixedEnd().stream().toList());
		final Movie bright = bright(movie, parameters, frames, workers, progress);
		return new PreparedMovie(
			new FramePreparer(bright, parameters).prepare(frames, workers, progress),
			WorkingPixels.SAME, List.of(), Clipping.of(bright, frames).kinds(),
			bright == movie ? List.of() : List.of(EvidenceNotes.DARK));
	}

	/** @return the same with other light and graphs in its frames, and one note more */
	PreparedMovie with(final List<FrameView> others, final String note) {
		final List<String> more = new ArrayList<>(notes);
		more.add(note);
		return new PreparedMovie(others, pixels, lost, kinds, more);
	}

	/** @return the frames that were resolved, and those without light */
	List<Observation> withLost(final Collection<Observation> resolved) {
		final List<Observation> all = new ArrayList<>(lost);
		all.addAll(resolved);
		return all;
	}

	/** The movie with bright lines; the published method does not look whether they are dark. */
	static Movie bright(final Movie movie, final Settings parameters, final List<Integer> frames,
		final Workers workers, final Progress progress) {
		Polarity polarity = parameters.segmentation().polarity();
		if (polarity == Polarity.AUTO && !parameters.isPublished())
			polarity = new AppearanceFinder(workers, progress).polarity(movie, frames);
		return polarity == Polarity.DARK
			? new Movie(movie.name(), inverted(movie.frames()), movie.calibration())
			: movie;
	}

	private static RandomAccessibleInterval<DoubleType> inverted(
		final RandomAccessibleInterval<? extends RealType<?>> frames) {
		return Converters.convert2(frames, (in, out) -> out.set(-in.getRealDouble()),
			DoubleType::new);
	}
}
