package io.github.knotresolver.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;

/**
 * The command line in a process of its own, with an engine that reads contours
 * from a file ({@code frame,x,y}, 1-based pixels) or waits to be cancelled.
 */
public final class TruthMain {

	private TruthMain() {
	}

	public static void main(final String[] args) {
		final String contours = System.getProperty("contours", "");
		final Engine engine = contours.isEmpty()
			? (m, p, progress) -> waitForCancel(progress)
			: (m, p, progress) -> known(m, p, Path.of(contours));
		KnotResolverMain.start(engine, args);
	}

	private static Tracks waitForCancel(final Progress progress) {
		System.out.println("started");
		while (true) {
			progress.checkCancelled();
			try {
				Thread.sleep(20);
			} catch (final InterruptedException e) {
				throw new IllegalStateException(e);
			}
		}
	}

	private static Tracks known(final Movie movie, final Settings parameters, final Path file) {
		final Map<Integer, List<Point>> points = new TreeMap<>();
		try {
			for (final String line : Files.readAllLines(file)) {
				final String[] cells = line.split(",");
				points.computeIfAbsent((int) Double.parseDouble(cells[0]), f -> new ArrayList<>())
					.add(new Point(Double.parseDouble(cells[1]) - 1,
						Double.parseDouble(cells[2]) - 1));
			}
		} catch (final IOException e) {
			throw new UncheckedIOException(e);
		}
		final List<Observation> frames = IntStream.rangeClosed(1, movie.size())
			.mapToObj(f -> points.containsKey(f)
				? new Observation(f, FrameStatus.RESOLVED, "",
					Optional.of(Polyline.of(points.get(f))), 1, 3, 0.2, 0.95)
				: Observation.without(f, FrameStatus.LOST, "No contour in the file."))
			.toList();
		return new Tracks(movie, parameters,
			List.of(new FilamentTrack(1, Anchor.CLAMPED,
				frames.get(0).contour().map(Polyline::first), Double.NaN, Double.NaN, frames)),
			List.of());
	}
}
