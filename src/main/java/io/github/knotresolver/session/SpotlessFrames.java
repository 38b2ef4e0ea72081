package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;

import net.imglib2.Localizable;
import net.imglib2.RandomAccess;
import net.imglib2.RandomAccessibleInterval;
import net.imglib2.position.FunctionRandomAccessible;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;
import net.imglib2.view.Views;

import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.progress.Cancellation;

/**
 * The frames of a movie less light that stays. Where that dazzles, a pixel says nothing of what
 * else is there: a line that comes out on both sides is taken to go straight through. So the
 * pixel is as bright as the darker of the two nearest pixels on both sides that say something,
 * in the direction in which that is brightest (a closing by segments).
 */
final class SpotlessFrames {

	/** Of half a turn. */
	private static final int DIRECTIONS = 12;

	private final Movie movie;
	private final float[] light;
	private final int width, height, sign;
	private final double dazzling;
	/** Of each dazzled pixel, the pixels on both sides. */
	private final Map<Integer, List<Sides>> dazzled = new HashMap<>();

	/**
	 * @param movie the movie
	 * @param light the light for every pixel, at least 0
	 * @param lines what the movie's lines look like
	 */
	SpotlessFrames(final Movie movie, final float[] light, final LineAppearance lines) {
		this.movie = movie;
		this.light = light;
		width = movie.width();
		height = movie.height();
		sign = lines.polarity() == Polarity.DARK ? -1 : 1;
		dazzling = SessionTuning.DAZZLING * lines.strand();
		for (int at = 0; at < light.length; at++)
			if (isDazzled(at % width, at / width)) {
				Cancellation.check();
				dazzled.put(at, sides(at % width, at / width));
			}
	}

	/** The two pixels on both sides, row by row. */
	private record Sides(int one, int other) {
	}

	/** Whether the light dazzles there or beside it. */
	private boolean isDazzled(final int x, final int y) {
		for (int v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); v++)
			for (int u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); u++)
				if (light[v * width + u] > dazzling)
					return true;
		return false;
	}

	private List<Sides> sides(final int x, final int y) {
		final List<Sides> sides = new ArrayList<>();
		for (int k = 0; k < DIRECTIONS; k++) {
			final double angle = Math.PI * k / DIRECTIONS;
			final int one = side(x, y, Math.cos(angle), Math.sin(angle)),
				other = side(x, y, -Math.cos(angle), -Math.sin(angle));
			if (one >= 0 && other >= 0)
				sides.add(new Sides(one, other));
		}
		return sides;
	}

	/** The nearest pixel in a direction that says something; -1 if there is none in the frame. */
	private int side(final int x, final int y, final double dx, final double dy) {
		for (int step = 1; step < width + height; step++) {
			final int u = (int) Math.rint(x + step * dx), v = (int) Math.rint(y + step * dy);
			if (u < 0 || v < 0 || u >= width || v >= height)
				return -1;
			if (!isDazzled(u, v))
				return v * width + u;
		}
		return -1;
	}

	/** @return the frames, x, y and t; made anew whenever a pixel is asked for */
	RandomAccessibleInterval<FloatType> frames() {
		return Views.interval(
			new FunctionRandomAccessible<>(3, () -> values(movie.frames()), FloatType::new),
			movie.frames());
	}

	private <T extends RealType<?>> BiConsumer<Localizable, FloatType> values(
		final RandomAccessibleInterval<T> frames) {
		final RandomAccess<T> pixels = frames.randomAccess();
		final long left = frames.min(0), top = frames.min(1);
		return (place, out) -> {
			final int at = (int) ((place.getLongPosition(1) - top) * width
				+ place.getLongPosition(0) - left);
			pixels.setPosition(place);
			final List<Sides> sides = dazzled.isEmpty() ? null : dazzled.get(at);
			if (sides == null || sides.isEmpty()) {
				out.set(pixels.get().getRealFloat() - sign * light[at]);
				return;
			}
			float most = Float.NEGATIVE_INFINITY;
			for (final Sides s : sides)
				most = Math.max(most,
					Math.min(value(pixels, s.one, left, top), value(pixels, s.other, left, top)));
			out.set(sign * most);
		};
	}

	/** A pixel of the frame in which the access is, lines bright. */
	private float value(final RandomAccess<? extends RealType<?>> pixels, final int at,
		final long left, final long top) {
		pixels.setPosition(left + at % width, 0);
		pixels.setPosition(top + at / width, 1);
		return sign * pixels.get().getRealFloat() - light[at];
	}
}
