package io.github.knotresolver.imagej;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.evaluate.FrameScore;
import io.github.knotresolver.evaluate.like.LikeResult;
import io.github.knotresolver.evaluate.like.LikeStudy;
import io.github.knotresolver.imagej.plot.Pictures;
import io.github.knotresolver.imagej.plot.ScoreFigures;
import io.github.knotresolver.io.LikeTables;
import io.github.knotresolver.io.ParametersJson;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.SimulatedMovie;

/** A study of movies like a user's as a folder of tables and figures. */
public final class LikeFolder {

	/** The name of the picture that shows both movies. */
	public static final String COMPARISON = "comparison.png";

	private LikeFolder() {
	}

	/**
	 * Writes a complete folder or nothing.
	 *
	 * @param study what was run
	 * @param result what came of it
	 * @param folder the reserved folder; committed here
	 * @param plots whether figures are drawn
	 * @param progress may cancel; nothing is left then
	 * @return what was left out and why, a sentence or two each
	 * @throws IOException if a file cannot be written
	 */
	public static List<String> write(final LikeStudy study, final LikeResult result,
		final ResultFolder folder, final boolean plots, final Progress progress)
		throws IOException {
		final List<String> leftOut = new ArrayList<>();
		LikeTables.write(folder.path(), result);
		ParametersJson.write(folder.path().resolve(ParametersJson.FILE), result);
		if (plots) {
			final List<List<FrameScore>> frames = result.movies().stream()
				.map(m -> m.evaluation().frames()).toList();
			leftOut.addAll(
				ScoreFigures.write(folder.path(), "", frames, result.positionErrors(), progress));
			final Pictures pictures = new Pictures(folder.path());
			final SimulatedMovie first = study.movie(result.motion(), result.movies().get(0).seed(),
				progress);
			pictures.drawPng(COMPARISON,
				() -> SideBySide.of(result.source().movie(), first.movie()));
			leftOut.addAll(pictures.notes());
		}
		progress.checkCancelled();
		folder.commit();
		return leftOut;
	}
}
