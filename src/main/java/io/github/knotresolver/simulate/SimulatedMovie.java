package io.github.knotresolver.simulate;

import java.util.List;

import net.imglib2.Cursor;
import net.imglib2.img.Img;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.type.numeric.IntegerType;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;

/**
 * A movie whose truth is known.
 *
 * @param movie 8 or 16 bit, calibrated in µm and s
 * @param truth the filament in every frame, in pixels, the clamped end first, a
 *          point every half pixel
 */
public record SimulatedMovie(Movie movie, List<Polyline> truth) {

	/** Most pixels of a whole movie: what one array holds. */
	private static final long MOST_PIXELS = 2_000_000_000;

	public SimulatedMovie {
		truth = List.copyOf(truth);
	}

	/**
	 * Draws a movie.
	 *
	 * @param name the movie's name
	 * @param trajectory the filament's shapes in µm
	 * @param canvas the view
	 * @param renderer draws one frame
	 * @param depth 8 or 16 bit
	 * @param progress told after every frame; may cancel
	 * @return the movie and its truth
	 * @throws UserException if the movie would have more than two
	 *           thousand million pixels
	 */
	public static SimulatedMovie render(final String name, final Trajectory trajectory,
		final Canvas canvas, final FrameRenderer renderer, final BitDepth depth,
		final Progress progress) {
		final List<Polyline> truth = canvas.truth(trajectory);
		final long pixels = (long) canvas.width() * canvas.height() * truth.size();
		if (pixels > MOST_PIXELS)
			throw new UserException("frames are too many for one movie: " + truth.size() + " of "
				+ canvas.width() + " x " + canvas.height()
				+ " pixels, more than 2000 million pixels; choose fewer frames or larger pixels.");
		final Img<? extends IntegerType<?>> frames = blank(canvas, truth.size(), depth);
		final Cursor<? extends IntegerType<?>> pixel = frames.cursor();
		for (int t = 0; t < truth.size(); t++) {
			progress.checkCancelled();
			for (final double v : renderer.render(truth.get(t), t, canvas, depth))
				pixel.next().setInteger(depth.quantized(v));
			progress.report("Rendering", (t + 1.0) / truth.size());
		}
		return new SimulatedMovie(new Movie(name, frames, canvas.calibration()), truth);
	}

	private static Img<? extends IntegerType<?>> blank(final Canvas canvas, final int frames,
		final BitDepth depth) {
		return depth == BitDepth.EIGHT
			? ArrayImgs.unsignedBytes(canvas.width(), canvas.height(), frames)
			: ArrayImgs.unsignedShorts(canvas.width(), canvas.height(), frames);
	}
}
