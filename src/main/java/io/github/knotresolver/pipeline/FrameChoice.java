package io.github.knotresolver.pipeline;

import java.util.Collection;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.Movie;

/** Which frames are to be resolved, once movie and parameters are known to fit together. */
record FrameChoice(Movie movie, Parameters parameters) {

	/** @return 1-based numbers, rising, at least one */
	List<Integer> frames() {
		requireInside("frames", parameters.frames());
		requireInside("ignore_frames", parameters.ignoreFrames());
		requireInside("corrections", parameters.corrections().keySet());
		parameters.fixedEnd().ifPresent(this::requireInside);
		final List<Integer> wanted = IntStream.rangeClosed(1, movie.size()).boxed()
			.filter(f -> parameters.frames().isEmpty() || parameters.frames().contains(f))
			.filter(f -> !parameters.ignoreFrames().contains(f)).toList();
		if (wanted.isEmpty())
			throw new IllegalArgumentException(
				"No frame is left to resolve: frames and ignore_frames leave none of the "
					+ movie.size() + " frames of '" + movie.name() + "'.");
		return wanted;
	}

	private void requireInside(final String name, final Collection<Integer> numbers) {
		for (final int frame : numbers)
			if (frame < 1 || frame > movie.size())
				throw new IllegalArgumentException(name + " names frame " + frame + ", but '"
					+ movie.name() + "' has frames 1 to " + movie.size() + ".");
	}

	private void requireInside(final Point end) {
		if (!(end.x() >= -0.5 && end.x() <= movie.width() - 0.5 && end.y() >= -0.5
			&& end.y() <= movie.height() - 0.5))
			throw new IllegalArgumentException("fixed_end " + end + " is outside the image of "
				+ movie.width() + " x " + movie.height()
				+ " pixels; give x,y in pixels, counted from 0 at the top left.");
	}
}
