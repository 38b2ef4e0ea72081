package io.github.knotresolver.evaluate.like;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Movie;

/**
 * A movie with its filament taken out: pixels near the contour come from the
 * nearest frame in which the filament lies elsewhere. Noise, specks, other
 * filaments and uneven light stay as they are. Beyond its edges the picture goes
 * on as its mirror image.
 */
final class Backdrop {

	private final Movie movie;
	private final List<Optional<BitSet>> covered = new ArrayList<>();
	private final int reach;
	private final double level;

	/**
	 * @param movie the movie
	 * @param contours one entry a frame, in pixels
	 * @param reach how far from the contour the filament's light is seen, in pixels
	 * @param level grey value where nothing else is known
	 */
	Backdrop(final Movie movie, final List<Optional<Polyline>> contours, final double reach,
		final double level) {
		this.movie = movie;
		this.reach = (int) Math.ceil(reach);
		this.level = level;
		for (final Optional<Polyline> contour : contours)
			covered.add(contour.map(c -> near(c, reach)));
	}

	private BitSet near(final Polyline contour, final double reach) {
		final NearField field = new NearField(contour, movie.width(), movie.height(), reach);
		final BitSet near = new BitSet(movie.width() * movie.height());
		for (int i = 0; i < movie.width() * movie.height(); i++)
			near.set(i, field.distance(i) <= reach);
		return near;
	}

	/**
	 * @param frame 0-based index
	 * @return its grey values without the filament, row by row
	 */
	private double[] frame(final int frame) {
		final double[] pixels = new double[movie.width() * movie.height()];
		final BitSet open = new BitSet(pixels.length);
		open.set(0, pixels.length);
		for (int away = 0; away < movie.size() && !open.isEmpty(); away++)
			for (final int from : away == 0
				? new int[]{frame}
				: new int[]{frame - away, frame + away})
				if (from >= 0 && from < movie.size() && covered.get(from).isPresent())
					fill(pixels, open, from);
		open.stream().forEach(i -> pixels[i] = beside(pixels, open, i));
		return pixels;
	}

	/** Where the filament always lies: the picture to the left or right of it. */
	private double beside(final double[] pixels, final BitSet open, final int pixel) {
		final int width = movie.width(), row = pixel / width * width;
		for (int way = 2 * reach; way < width; way += reach)
			for (final int column : new int[]{pixel - row - way, pixel - row + way})
				if (column >= 0 && column < width && !open.get(row + column))
					return pixels[row + column];
		return level;
	}

	private void fill(final double[] pixels, final BitSet open, final int from) {
		final BitSet shown = (BitSet) open.clone();
		shown.andNot(covered.get(from).orElseThrow());
		if (shown.isEmpty())
			return;
		final double[] source = Pixels.doubles(movie.frame(from));
		shown.stream().forEach(i -> pixels[i] = source[i]);
		open.andNot(shown);
	}

	/**
	 * A view of a frame.
	 *
	 * @param frame 0-based index
	 * @param width of the view in pixels
	 * @param height of the view in pixels
	 * @param from place in the movie's pixels that is to be at {@code to}
	 * @param to place in the view
	 * @param flipX whether left and right are exchanged
	 * @param flipY whether top and bottom are exchanged
	 * @return grey values row by row
	 */
	double[] view(final int frame, final int width, final int height, final Point from,
		final Point to, final boolean flipX, final boolean flipY) {
		final double[] source = frame(frame);
		final double[] view = new double[width * height];
		for (int y = 0; y < height; y++) {
			final int row = mirrored(from.y() + (flipY ? to.y() - y : y - to.y()), movie.height());
			for (int x = 0; x < width; x++) {
				final int column = mirrored(from.x() + (flipX ? to.x() - x : x - to.x()),
					movie.width());
				final double value = source[row * movie.width() + column];
				view[y * width + x] = Double.isNaN(value) ? level : value;
			}
		}
		return view;
	}

	private static int mirrored(final double place, final int size) {
		final int at = Math.floorMod((int) Math.rint(place), 2 * size);
		return at < size ? at : 2 * size - 1 - at;
	}
}
