package io.github.knotresolver.reproduction;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import net.imglib2.view.Views;

import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.simulate.SimulatedMovie;

/**
 * What is asked of the methods.
 *
 * @param snr signal-to-noise ratio in dB
 * @param step every how manyth frame they see
 */
public record Condition(double snr, int step) {

	/** The published noise levels, in dB. */
	public static final List<Double> NOISE = List.of(5.0, 10.0, 20.0, 30.0);
	/** The published frame intervals, and every frame. */
	public static final List<Integer> STEPS = List.of(1, 5, 10, 30);
	/** Noise of the movies that are thinned out, in dB. */
	public static final double THINNED_NOISE = 10;

	/** @return what is asked at a noise level */
	static List<Condition> at(final double snr) {
		return STEPS.stream().filter(s -> s == 1 || snr == THINNED_NOISE)
			.map(s -> new Condition(snr, s)).toList();
	}

	/** @return every condition, in the document's order */
	static List<Condition> all() {
		return Stream.concat(NOISE.stream().map(n -> new Condition(n, 1)),
			STEPS.stream().skip(1).map(s -> new Condition(THINNED_NOISE, s))).toList();
	}

	/** @return the frames that the methods see, with their truth */
	SimulatedMovie of(final SimulatedMovie all) {
		final Movie movie = all.movie();
		final Calibration c = movie.calibration();
		return new SimulatedMovie(
			new Movie(movie.name(), Views.subsample(movie.frames(), 1, 1, step),
				new Calibration(c.pixelSize(), c.unit(), c.frameInterval() * step, c.timeUnit())),
			IntStream.range(0, all.truth().size()).filter(t -> t % step == 0)
				.mapToObj(all.truth()::get).toList());
	}

	/** @return the movie's frame (1-based) that a method knows as {@code frame} */
	int original(final int frame) {
		return (frame - 1) * step + 1;
	}
}
