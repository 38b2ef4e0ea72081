package io.github.knotresolver.evaluate.like;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.UserException;

/**
 * A user's finished result: what the simulated movies are to resemble.
 *
 * @param movie the movie it was made from
 * @param contours one entry a frame of the movie, in pixels, fixed end first;
 *          empty where a frame has none
 * @param parameters what it was resolved with
 */
public record LikeSource(Movie movie, List<Optional<Polyline>> contours, Settings parameters) {

	/** Fewest pairs of neighbouring frames that tell a motion. */
	private static final int FEWEST_PAIRS = 2;

	/**
	 * Checks.
	 *
	 * @param movie the movie
	 * @param contours its contours
	 * @param parameters what they were made with
	 * @throws UserException if movie and contours do not belong
	 *           together, or tell too little, in one sentence
	 */
	public LikeSource {
		contours = List.copyOf(contours);
		if (contours.size() != movie.size())
			throw new UserException(
				"movie '" + movie.name() + "' has " + movie.size() + " frames, but the result has "
					+ contours.size() + "; name the movie that the result was made from.");
		final List<Optional<Polyline>> all = contours;
		if (IntStream.range(1, all.size())
			.filter(t -> all.get(t - 1).isPresent() && all.get(t).isPresent())
			.count() < FEWEST_PAIRS)
			throw new UserException("like has contours in fewer than " + (FEWEST_PAIRS + 1)
				+ " neighbouring frames, too few to see how the filament moves; resolve a longer part of the movie.");
		micrometres(movie.calibration().unit());
	}

	/** @return edge of a pixel in µm */
	double pixelSize() {
		return movie.calibration().pixelSize() * micrometres(movie.calibration().unit());
	}

	/** @return time between frames in s; empty if the movie does not tell it */
	OptionalDouble secondsPerFrame() {
		final double interval = movie.calibration().frameInterval();
		return switch (movie.calibration().timeUnit()) {
			case "s" -> OptionalDouble.of(interval);
			case "ms" -> OptionalDouble.of(1e-3 * interval);
			case "min" -> OptionalDouble.of(60 * interval);
			default -> OptionalDouble.empty();
		};
	}

	private static double micrometres(final String unit) {
		return switch (unit) {
			case "µm" -> 1;
			case "nm" -> 1e-3;
			case "mm" -> 1e3;
			default -> throw new UserException("like is a result in the unit '" + unit
				+ "', but a simulation needs micrometres; resolve the movie again and tell its pixel size.");
		};
	}
}
