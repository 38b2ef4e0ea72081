package io.github.knotresolver.imagej;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.image.Movie;
import io.github.knotresolver.pipeline.Parameters;
import io.github.knotresolver.pipeline.Region;
import io.github.knotresolver.pipeline.Resolution;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.track.TrackedFrame;

/** Searches a part of the movie; the result is in the whole movie's pixels. */
record RegionEngine(Engine engine, Region region) implements Engine {

	@Override
	public Resolution resolve(final Movie movie, final Parameters parameters,
		final Progress progress) {
		final Resolution found = engine.resolve(region.of(movie), region.of(parameters), progress);
		final List<String> notes = new ArrayList<>(found.notes());
		notes.add("Only the region x=" + region.x() + " y=" + region.y() + " width="
			+ region.width() + " height=" + region.height() + " was searched.");
		return new Resolution(movie, parameters, found.fixedEnd().map(region::back), found.length(),
			found.lengthUncertainty(), found.frames().stream().map(this::back).toList(), notes);
	}

	private TrackedFrame back(final TrackedFrame f) {
		return new TrackedFrame(f.frame(), f.status(), f.reason(), f.contour().map(region::back),
			f.junctions(), f.candidates(), f.cost(), f.confidence());
	}
}
