package io.github.knotresolver.imagej;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.evaluate.Evaluation.FrameScore;
import io.github.knotresolver.evaluate.like.LikeResult;
import io.github.knotresolver.evaluate.like.LikeStudy;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.imagej.plot.Pictures;
import io.github.knotresolver.imagej.plot.ScoreFigures;
import io.github.knotresolver.io.LikeTables;
import io.github.knotresolver.io.ParametersJson;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.model.Movie;
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

	/**
	 * Two movies in one picture, a row each, in the same grey values and at the same
	 * scale: whoever looks sees whether they are alike.
	 */
	private static final class SideBySide {

		private static final int COLUMNS = 5, GAP = 6, TITLE = 22, MOST_WIDTH = 2400,
			LARGEST_SCALE = 3;

		private SideBySide() {
		}

		/** @return frames of both movies, spread over their time, the user's above */
		static BufferedImage of(final Movie yours, final Movie simulated) {
			final int columns = Math.min(COLUMNS, Math.min(yours.size(), simulated.size()));
			final int cell = Math.max(yours.width(), simulated.width());
			final int scale = Math.max(1, Math.min(LARGEST_SCALE, MOST_WIDTH / (cell * columns)));
			final BufferedImage picture = new BufferedImage(columns * (cell * scale + GAP) - GAP,
				2 * TITLE + scale * (yours.height() + simulated.height()) + GAP,
				BufferedImage.TYPE_INT_RGB);
			final Graphics2D graphics = picture.createGraphics();
			graphics.setColor(Color.WHITE);
			graphics.fillRect(0, 0, picture.getWidth(), picture.getHeight());
			final double[] range = range(yours);
			row(graphics, "yours", yours, 0, columns, cell, scale, range);
			row(graphics, "simulated", simulated, TITLE + yours.height() * scale + GAP, columns,
				cell, scale, range);
			graphics.dispose();
			return picture;
		}

		private static void row(final Graphics2D graphics, final String title, final Movie movie,
			final int top, final int columns, final int cell, final int scale,
			final double[] range) {
			graphics.setColor(Color.BLACK);
			graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 15));
			for (int i = 0; i < columns; i++) {
				final int frame = columns == 1 ? 0 : i * (movie.size() - 1) / (columns - 1);
				final int left = i * (cell * scale + GAP);
				graphics.drawString(title + ", frame " + (frame + 1), left + 2, top + TITLE - 6);
				graphics.drawImage(grey(movie, frame, range), left, top + TITLE,
					movie.width() * scale, movie.height() * scale, null);
			}
		}

		private static BufferedImage grey(final Movie movie, final int frame,
			final double[] range) {
			final BufferedImage image = new BufferedImage(movie.width(), movie.height(),
				BufferedImage.TYPE_BYTE_GRAY);
			final double[] pixels = Pixels.doubles(movie.frame(frame));
			for (int i = 0; i < pixels.length; i++) {
				final double share = (pixels[i] - range[0]) / (range[1] - range[0]);
				final int grey = (int) Math.rint(255 * Math.max(0, Math.min(1, share)));
				image.getRaster().setSample(i % movie.width(), i / movie.width(), 0, grey);
			}
			return image;
		}

		private static double[] range(final Movie movie) {
			double low = Double.POSITIVE_INFINITY, high = Double.NEGATIVE_INFINITY;
			for (int t = 0; t < movie.size(); t++)
				for (final double v : Pixels.doubles(movie.frame(t))) {
					low = v < low ? v : low;
					high = v > high ? v : high;
				}
			return new double[]{low, Math.max(high, low + 1e-9)};
		}
	}
}
