package io.github.knotresolver.imagej;

import java.awt.Rectangle;
import java.util.Optional;
import java.util.TreeMap;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.view.Views;

import ij.ImagePlus;
import ij.gui.Roi;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Movie;
import io.github.knotresolver.pipeline.Parameters;

/**
 * The part of a movie that a search is limited to: the bounds of an area
 * selection.
 *
 * @param x first column
 * @param y first row
 * @param width number of columns
 * @param height number of rows
 */
public record Region(int x, int y, int width, int height) {

	/** Too small to hold a filament. */
	private static final int LEAST = 8;

	/**
	 * @param image an image
	 * @return the bounds of its area selection; empty if it has none, or all is
	 *         selected
	 * @throws IllegalArgumentException if it is too small, in one sentence
	 */
	public static Optional<Region> selected(final ImagePlus image) {
		final Roi roi = image.getRoi();
		if (roi == null || !roi.isArea())
			return Optional.empty();
		final Rectangle all = new Rectangle(image.getWidth(), image.getHeight());
		final Rectangle part = roi.getBounds().intersection(all);
		if (part.equals(all))
			return Optional.empty();
		if (part.width < LEAST || part.height < LEAST)
			throw new IllegalArgumentException("The selection in '" + image.getTitle() + "' is "
				+ Math.max(0, part.width) + " x " + Math.max(0, part.height)
				+ " pixels, too small for a filament; draw a larger one, or none to search the whole image.");
		return Optional.of(new Region(part.x, part.y, part.width, part.height));
	}

	/** @return this part of the movie; pixels are shared */
	Movie of(final Movie movie) {
		return new Movie(movie.name(), part(movie.frames()), movie.calibration());
	}

	private <T> RandomAccessibleInterval<T> part(final RandomAccessibleInterval<T> frames) {
		final long[] min = frames.minAsLongArray();
		return Views.zeroMin(Views.interval(frames, new long[]{min[0] + x, min[1] + y, min[2]},
			new long[]{min[0] + x + width - 1, min[1] + y + height - 1, frames.max(2)}));
	}

	/** @return the parameters in this part's own pixels */
	Parameters of(final Parameters p) {
		final var corrections = new TreeMap<Integer, Polyline>();
		p.corrections().forEach((frame, c) -> corrections.put(frame, moved(c, -x, -y)));
		return new Parameters(p.fixedEnd().map(this::inside), p.cleaning(), p.segmentation(),
			p.candidates(), p.resolver(), p.length(), p.lengthModel(), p.refine(), p.frames(),
			p.ignoreFrames(), corrections, p.threads());
	}

	private Point inside(final Point end) {
		final Point moved = new Point(end.x() - x, end.y() - y);
		if (moved.x() < -0.5 || moved.y() < -0.5 || moved.x() > width - 0.5
			|| moved.y() > height - 0.5)
			throw new IllegalArgumentException("fixed_end " + end
				+ " lies outside the selection; move the selection, or remove it to search the whole image.");
		return moved;
	}

	/** @return the contour in the whole movie's pixels */
	Polyline back(final Polyline contour) {
		return moved(contour, x, y);
	}

	/** @return the point in the whole movie's pixels */
	Point back(final Point point) {
		return new Point(point.x() + x, point.y() + y);
	}

	private static Polyline moved(final Polyline contour, final int dx, final int dy) {
		final double[] x = contour.xs(), y = contour.ys();
		for (int i = 0; i < x.length; i++) {
			x[i] += dx;
			y[i] += dy;
		}
		return Polyline.of(x, y);
	}
}
