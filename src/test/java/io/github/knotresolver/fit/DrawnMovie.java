package io.github.knotresolver.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

import net.imglib2.img.array.ArrayImgs;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;

/**
 * Movies of a clamped, beating filament, drawn with the line models of the fit, for tests.
 *
 * @param movie the movie
 * @param truth the curve in each frame
 * @param model the line it was drawn with
 */
public record DrawnMovie(Movie movie, List<Polyline> truth, LineModel model) {

	/** Edge of the picture in pixels. */
	public static final int SIZE = 110;

	private static final int LINKS = 60;
	private static final double BRIGHTNESS = 120;
	private static final double BACKGROUND = 40;

	/**
	 * A wave that travels from the fixed end to the tip; with a large amplitude the filament
	 * crosses itself.
	 *
	 * @param t frame
	 * @param length in pixels
	 * @param amplitude of the tangent angle in radians
	 * @return the chain
	 */
	public static Chain wave(final double t, final double length, final double amplitude) {
		final double[] theta = new double[LINKS];
		for (int i = 0; i < LINKS; i++) {
			final double s = (i + 0.5) / LINKS;
			theta[i] = 0.3 + amplitude * Math.sqrt(s) * Math.sin(5 * s - 0.2 * t);
		}
		return new Chain(22.4, 55.3, theta, length / LINKS);
	}

	/**
	 * Draws a movie.
	 *
	 * @param chains the filament in each frame; null for a frame without it
	 * @param foreign other curves in each frame, as bright as the filament; may be empty
	 * @param model what a line looks like
	 * @param noise standard deviation relative to a strand's brightness
	 * @param seed of the noise
	 * @return the movie
	 */
	public static DrawnMovie draw(final List<Chain> chains, final List<List<Chain>> foreign,
		final LineModel model, final double noise, final long seed) {
		final Random random = new Random(seed);
		final float[] pixels = new float[SIZE * SIZE * chains.size()];
		for (int t = 0; t < chains.size(); t++) {
			final double[] frame = picture(chains.get(t), model);
			if (!foreign.isEmpty())
				for (final Chain other : foreign.get(t)) {
					final double[] more = picture(other,
						LineModel.uniform(model.kind(), model.sigma(), model.power()));
					for (int i = 0; i < frame.length; i++)
						frame[i] = model.kind() == LineModel.Kind.ADDITIVE
							? frame[i] + more[i]
							: Math.max(frame[i], more[i]);
				}
			for (int i = 0; i < frame.length; i++)
				pixels[t * frame.length + i] = (float) (BACKGROUND
					+ BRIGHTNESS * (frame[i] + noise * random.nextGaussian()));
		}
		final List<Polyline> truth = new ArrayList<>();
		chains.forEach(c -> truth.add(c == null ? null : c.polyline()));
		return new DrawnMovie(new Movie("drawn",
			ArrayImgs.floats(pixels, SIZE, SIZE, chains.size()), Calibration.NONE), truth, model);
	}

	/** A frame of the movie in the units of the fit. */
	public NormalizedFrame frame(final int t) {
		final double[] pixels = Pixels.doubles(movie.frame(t));
		return new NormalizedFrame(SIZE, SIZE, pixels).rescaled(BACKGROUND, BRIGHTNESS);
	}

	private static double[] picture(final Chain chain, final LineModel model) {
		final NormalizedFrame dark = new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
		return chain == null ? dark.pixels().clone() : ChainPixels.draw(dark, model, chain);
	}

	/**
	 * @param frames how many
	 * @param length in pixels
	 * @param amplitude of the tangent angle
	 * @return a wave frame by frame
	 */
	public static List<Chain> waves(final int frames, final double length, final double amplitude) {
		final Chain[] chains = new Chain[frames];
		Arrays.setAll(chains, t -> wave(t, length, amplitude));
		return new ArrayList<>(Arrays.asList(chains));
	}

	/**
	 * A straight filament that is pushed towards its clamp and winds up there.
	 *
	 * @param wound length that has wound up, in pixels
	 * @param length in pixels
	 * @param radius of the curl in pixels
	 * @return the chain
	 */
	public static Chain winding(final double wound, final double length, final double radius) {
		final double[] theta = new double[LINKS];
		for (int i = 0; i < LINKS; i++)
			theta[i] = 0.02 - Math.max(0, wound - (i + 0.5) * length / LINKS) / radius;
		return new Chain(22.4, 55.3, theta, length / LINKS);
	}
}
