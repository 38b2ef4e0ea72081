package io.github.knotresolver.session;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.contour.DiscreteFrechet;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.FitEvidence;
import io.github.knotresolver.track.FitResolver;
import io.github.knotresolver.track.FixedEndFinder;

/**
 * What can be seen of every contour of movies with known truth, and whether it is right: what
 * {@code scripts/fit-confidence} learns the weights of the confidence from.
 */
public final class ConfidenceMain {

	/** A contour is right if its discrete Frechet distance to the truth is below this (pixels). */
	private static final double RIGHT = 5;

	private ConfidenceMain() {
	}

	/**
	 * @param args file of the table; movies, each with its truth beside it, called
	 *          {@code NAME_gt.csv}
	 * @throws IOException if a file cannot be read or written
	 */
	public static void main(final String[] args) throws IOException {
		final Path table = Path.of(args[0]);
		final boolean fresh = !Files.exists(table);
		for (int i = 1; i < args.length; i++)
			try (PrintStream out = new PrintStream(
				Files.newOutputStream(table, StandardOpenOption.CREATE, StandardOpenOption.APPEND),
				false, StandardCharsets.UTF_8)) {
				if (fresh && i == 1)
					out.println("movie,frame,right,confidence," + FitEvidence.NAMES);
				write(Path.of(args[i]), out);
			}
	}

	private static void write(final Path file, final PrintStream out) throws IOException {
		final String name = file.getFileName().toString().replaceFirst("\\.tif$", "");
		final Map<Integer, Polyline> truth = truth(
			file.resolveSibling(name.replaceFirst("_snr.*", "") + "_gt.csv"));
		final Movie movie = ImageMovie.of(ImageFile.open(file), InputOptions.DEFAULT);
		final Settings settings = RunOptions.parse(Map.of()).settings(movie, List.of());
		final List<Integer> wanted = new FrameChoice(movie, settings).frames();
		try (Workers workers = new Workers(settings.threads())) {
			final PreparedMovie prepared = PreparedMovie.of(movie, settings, wanted, workers,
				Progress.NONE);
			new FixedEndFinder(prepared.frames(), Progress.NONE).find()
				.flatMap(end -> new FitResolver(TrailCandidates.DEFAULT, prepared.kinds(),
					settings.lengthModel(), workers, Progress.NONE)
					.learn(prepared.frames(), end, settings.length()))
				.ifPresent(solver -> write(name, prepared,
					solver.solve(List.of(), workers, Progress.NONE).frames(),
					solver.evidence(Progress.NONE), truth, out));
		} catch (final IllegalArgumentException e) {
			System.err.println(file + ": " + e.getMessage());
		}
		System.err.println(name);
	}

	private static void write(final String name, final PreparedMovie prepared,
		final List<Observation> frames, final List<Optional<FitEvidence>> seen,
		final Map<Integer, Polyline> truth, final PrintStream out) {
		for (int t = 0; t < frames.size(); t++) {
			final Observation frame = frames.get(t);
			final Optional<FitEvidence> evidence = seen.get(t);
			final Polyline right = truth.get(frame.frame());
			if (right == null || frame.contour().isEmpty() || evidence.isEmpty())
				continue;
			final Polyline contour = frame.contour().get();
			final double off = DiscreteFrechet.distance(right,
				Polyline.of(IntStream.range(0, contour.size())
					.mapToObj(i -> prepared.pixels().out(contour.point(i))).toList()));
			out.println(name + "," + frame.frame() + "," + (off < RIGHT ? 1 : 0) + ","
				+ frame.confidence() + "," + evidence.get());
		}
	}

	private static Map<Integer, Polyline> truth(final Path file) throws IOException {
		final Map<Integer, List<Point>> points = new TreeMap<>();
		for (final String line : Files.readAllLines(file)) {
			final String[] cells = line.split(",");
			if (cells[0].equals("frame"))
				continue;
			points.computeIfAbsent(Integer.parseInt(cells[0]), f -> new ArrayList<>())
				.add(new Point(Double.parseDouble(cells[2]), Double.parseDouble(cells[3])));
		}
		final Map<Integer, Polyline> truth = new TreeMap<>();
		points.forEach((frame, curve) -> truth.put(frame, Polyline.of(curve)));
		return truth;
	}
}
