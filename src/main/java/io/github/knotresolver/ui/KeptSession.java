package io.github.knotresolver.ui;

import java.util.List;

import ij.ImagePlus;
import io.github.knotresolver.imagej.PixelSum;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;
import io.github.knotresolver.session.Session;
import io.github.knotresolver.ui.model.Solver;

/**
 * The engine of one run on an image, which remembers what it worked out, so that its result can be
 * reviewed: as long as the image has the pixels that were resolved.
 */
public final class KeptSession implements Engine, Solver {

	private final PixelSum pixels;
	private Session session;

	/** @param image that is about to be resolved; its pixels are shared with the movie */
	public KeptSession(final ImagePlus image) {
		pixels = PixelSum.of(image);
	}

	@Override
	public Tracks resolve(final Movie movie, final Settings settings, final Progress progress) {
		session = new Session(movie, settings.edit().constraints(List.of()).build());
		return session.solve(settings.constraints(), progress);
	}

	@Override
	public Tracks solve(final List<Constraint> said, final Progress progress) {
		requireSamePixels();
		return session.solve(said, progress);
	}

	/** Leaves the image its pixels also when it is closed, so that its result can still be saved. */
	void holdPixels() {
		pixels.image().setIgnoreFlush(true);
	}

	/** They go with the image again. */
	void releasePixels() {
		pixels.image().setIgnoreFlush(false);
	}

	/** @throws UserException if the image was edited since its run, in one sentence */
	void requireSamePixels() {
		if (!pixels.isSame())
			throw new UserException("The pixels of '" + pixels.image().getTitle()
				+ "' were changed since it was resolved, so the result does not belong to them any more; undo the change (Edit > Undo, File > Revert), or resolve the image again.");
	}
}
