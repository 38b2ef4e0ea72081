package io.github.knotresolver.session;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;

/**
 * Resolves movies for {@code scripts/benchmark}, all in one warm JVM: for every mode a
 * folder with the contours and the confidence of each movie, and {@code runs.csv} with
 * the time of each. A movie that fails has no contours and says why.
 */
public final class BenchmarkMain {

	/** The modes, as the command line's options. */
	private static final Map<String, Map<String, String>> MODES = Map.of("default", Map.of(),
		"published", Map.of("candidates", "paper", "resolver", "paper", "refine", "false"));

	private final Path out;

	BenchmarkMain(final Path out) {
		this.out = out;
	}

	/**
	 * @param args folder of the results, modes separated by commas, movies
	 * @throws IOException if a file cannot be written
	 */
	public static void main(final String[] args) throws IOException {
		final BenchmarkMain benchmark = new BenchmarkMain(Path.of(args[0]));
		final List<Path> movies = Arrays.stream(args).skip(2).map(Path::of).toList();
		for (final String mode : args[1].split(",")) {
			resolve(open(movies.get(0)), MODES.get(mode));
			benchmark.run(mode, movies);
		}
	}

	void run(final String mode, final List<Path> movies) throws IOException {
		final Path folder = Files.createDirectories(out.resolve(mode));
		final Map<String, String> options = MODES.get(mode);
		try (PrintStream runs = writer(folder.resolve("runs.csv"))) {
			runs.println("movie,seconds,failure");
			for (final Path file : movies) {
				final Movie movie = open(file);
				final String name = file.getFileName().toString().replaceFirst("\\.tif$", "");
				final long start = System.nanoTime();
				final Tracks tracks = resolve(movie, options);
				final double seconds = (System.nanoTime() - start) * 1e-9;
				final Path result = Files.createDirectories(folder.resolve(name));
				writeContours(result.resolve("contours.csv"), tracks);
				writeFrames(result.resolve("frames.csv"), tracks);
				runs.printf(Locale.ROOT, "%s,%.3f,\"%s\"%n", name, seconds,
					tracks.resolved() > 0 ? "" : String.join(" ", tracks.notes()));
				System.err.printf(Locale.ROOT, "%s %s: %d frames, %.2f s%n", mode, name,
					tracks.resolved(), seconds);
			}
		}
	}

	private static Movie open(final Path file) {
		return ImageMovie.of(ImageFile.open(file), InputOptions.DEFAULT);
	}

	private static Tracks resolve(final Movie movie, final Map<String, String> options) {
		final Settings parameters = RunOptions.parse(options).parameters(movie);
		try {
			return new Session(movie, parameters).solve(List.of(), Progress.NONE);
		} catch (final UserException e) {
			final List<Observation> none = IntStream.rangeClosed(1, movie.size())
				.mapToObj(f -> Observation.without(f, FrameStatus.LOST, e.getMessage())).toList();
			return new Tracks(movie, parameters, List.of(new FilamentTrack(1, Anchor.CLAMPED,
				Optional.empty(), Double.NaN, Double.NaN, none)), List.of(e.getMessage()));
		}
	}

	private static void writeContours(final Path file, final Tracks tracks) throws IOException {
		try (PrintStream csv = writer(file)) {
			csv.println("filament,frame,index,x_px,y_px");
			for (final FilamentTrack track : tracks.filaments())
				for (final Observation frame : track.frames())
					frame.contour().ifPresent(c -> writePoints(csv, track.id(), frame.frame(), c));
		}
	}

	private static void writePoints(final PrintStream csv, final int filament, final int frame,
		final Polyline contour) {
		for (int i = 0; i < contour.size(); i++)
			csv.printf(Locale.ROOT, "%d,%d,%d,%.4f,%.4f%n", filament, frame, i, contour.x(i),
				contour.y(i));
	}

	private static void writeFrames(final Path file, final Tracks tracks) throws IOException {
		try (PrintStream csv = writer(file)) {
			csv.println("filament,frame,status,confidence");
			for (final FilamentTrack track : tracks.filaments())
				for (final Observation frame : track.frames())
					csv.printf(Locale.ROOT, "%d,%d,%s,%s%n", track.id(), frame.frame(),
						frame.status().label(),
						Double.isFinite(frame.confidence())
							? String.format(Locale.ROOT, "%.6f", frame.confidence())
							: "");
		}
	}

	private static PrintStream writer(final Path file) throws IOException {
		return new PrintStream(Files.newOutputStream(file), false, StandardCharsets.UTF_8);
	}
}
