package io.github.knotresolver.session;

import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.ShownNumber;
import io.github.knotresolver.model.UserException;

/** Which frames are to be resolved, once movie and parameters are known to fit together. */
public record FrameChoice(Movie movie, Settings parameters) {

	/**
	 * @return 1-based numbers of the frames to resolve, rising, at least one
	 * @throws UserException if the parameters name a frame, a place or a length
	 *           that the movie does not have, or leave no frame
	 */
	public List<Integer> frames() {
		requireInside("frames", parameters.frames());
		requireInside("ignore_frames", parameters.ignoreFrames());
		requireInside("corrections",
			parameters.constraints().stream().map(Constraint::frame).toList());
		parameters.fixedEnd().ifPresent(end -> requireInside("fixed_end", end));
		parameters.constraints().forEach(this::requireUsable);
		parameters.length().ifPresent(this::requirePossible);
		final List<Integer> wanted = IntStream.rangeClosed(1, movie.size()).boxed()
			.filter(f -> parameters.frames().isEmpty() || parameters.frames().contains(f))
			.filter(f -> !parameters.ignoreFrames().contains(f)).toList();
		if (wanted.isEmpty())
			throw new UserException(
				"No frame is left to resolve: each of the " + movie.size() + " frames of '"
					+ movie.name() + "' is ignored or not chosen; choose at least one.");
		return wanted;
	}

	private void requireInside(final String name, final Collection<Integer> numbers) {
		if (!numbers.isEmpty() && Collections.max(numbers) > movie.size())
			throw new UserException(name + " names frame " + Collections.max(numbers)
				+ ", but the movie has " + movie.size() + " frames.");
	}

	private void requireInside(final String what, final Point place) {
		if (!(place.x() >= -0.5 && place.x() <= movie.width() - 0.5 && place.y() >= -0.5
			&& place.y() <= movie.height() - 0.5))
			throw new UserException(what + " must lie inside the image of " + movie.width() + " x "
				+ movie.height() + " pixels, but is " + place + ".");
	}

	/** Of a contour both ends must be in the picture, of places all; a refused contour may be anywhere. */
	private void requireUsable(final Constraint constraint) {
		final String name = "The correction of frame " + constraint.frame();
		final Polyline shape = constraint.shape();
		switch (constraint.kind()) {
			case CONTOUR -> {
				requireInside(name + ": its first point", shape.first());
				requireInside(name + ": its last point", shape.last());
			}
			case THROUGH, TIP -> {
				for (int i = 0; i < shape.size(); i++)
					requireInside(name + ": its place", shape.point(i));
			}
			default -> {
			}
		}
	}

	private void requirePossible(final double length) {
		if (length > SessionTuning.LONGEST_TOLD * (movie.width() + movie.height()))
			throw new UserException("length is " + ShownNumber.of(length)
				+ " pixels, which is far too long for an image of " + movie.width() + " x "
				+ movie.height() + " pixels; give it in the image's unit, "
				+ movie.calibration().unit() + ".");
	}
}
