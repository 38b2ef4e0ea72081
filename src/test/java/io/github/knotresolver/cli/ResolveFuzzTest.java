package io.github.knotresolver.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tuple;

import io.github.knotresolver.fuzz.Drawings;
import io.github.knotresolver.fuzz.DrawnMovies;
import io.github.knotresolver.fuzz.Fuzzing;
import io.github.knotresolver.fuzz.Guard;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;

/**
 * The whole of {@code resolve}: small movies of all kinds with odd options and damaged bytes end in
 * a whole result, or in one sentence and none.
 */
class ResolveFuzzTest extends Fuzzing {

	/** Options with values that are allowed, and some that are not. */
	private static final String[][] OPTIONS = {{"fixed-end", "10,28", "0,0", "70.5,3", "-4,900"},
		{"region", "0,0,30,30", "5,5,2,2", "-3,-3,400,400"},
		{"threshold", "otsu", "0", "1", "0.4", "0.999"}, {"iterations", "0", "1", "100"},
		{"contraction-bias", "-1", "1", "0"}, {"smooth-factor", "0", "1", "20"},
		{"segmentation", "threshold", "active-contour"}, {"candidates", "paper", "trails"},
		{"resolver", "paper", "movie"}, {"length", "1e-9", "3", "40", "100000"},
		{"length-model", "free", "constant"}, {"channel", "1", "2", "0"},
		{"frames", "1", "2-3", "1-2", "1-2147483647", "9"}, {"ignore-frames", "1", "1-6", "2"},
		{"pixel-size", "0.1", "1e-300", "1e308"}, {"unit", "µm", "nm", "inch", "x"},
		{"frame-interval", "1e308", "0.02", "5"}, {"filaments", "one", "all"},
		{"anchor", "clamped", "free", "auto"}, {"polarity", "dark", "bright", "auto"}};

	private static final Guard GUARD = new Guard("resolve");

	@Provide
	Arbitrary<byte[]> movies() {
		return Arbitraries.frequencyOf(Tuple.of(6, DrawnMovies.any()), Tuple.of(1,
			Combinators.combine(DrawnMovies.any(), Drawings.edits()).as(Drawings::damaged)));
	}

	@Provide
	Arbitrary<List<String>> options() {
		final Arbitrary<List<String>> option = Arbitraries
			.of(Arrays.stream(OPTIONS).filter(o -> RunOptions.KEYS.contains(o[0].replace('-', '_')))
				.toList())
			.flatMap(
				o -> Arbitraries
					.frequencyOf(Tuple.of(19, Arbitraries.of(Arrays.copyOfRange(o, 1, o.length))),
						Tuple.of(1, Drawings.odd()))
					.map(value -> List.of("--" + o[0] + "=" + value)));
		final Arbitrary<List<String>> flag = Arbitraries.of(List.of("--no-refine"),
			List.of("--no-refine", "--candidates=paper", "--resolver=paper"),
			List.of("--z-as-time"), List.of("--log-size=5", "--log-sigma=1"),
			List.of("--log-size=71", "--log-sigma=50"));
		return Arbitraries.frequencyOf(Tuple.of(5, option), Tuple.of(1, flag)).list()
			.uniqueElements(o -> o.get(0).replaceFirst("=.*", "")).ofMaxSize(3)
			.map(all -> all.stream().flatMap(List::stream).toList());
	}

	@Provide
	Arbitrary<byte[]> corrections() {
		return Arbitraries.frequencyOf(Tuple.of(9, Arbitraries.just(new byte[0])),
			Tuple.of(1, Drawings.table(List.of("frame", "index", "x_px", "y_px"), List.of("note"))),
			Tuple.of(1, Drawings.table(
				List.of("filament", "frame", "kind", "index", "x_px", "y_px"), List.of("note"))));
	}

	@Property(seed = "20260103", shrinking = ShrinkingMode.OFF)
	void endsInAWholeResultOrInASentence(@ForAll("movies") final byte[] bytes,
		@ForAll("options") final List<String> options,
		@ForAll("corrections") final byte[] corrections) {
		folder.clear();
		final Path movie = folder.write("movie.tif", bytes), out = folder.path().resolve("out");
		final List<String> args = new ArrayList<>(List.of("--debug", "resolve", movie.toString(),
			"--out", out.toString(), "--threads=1"));
		args.addAll(options);
		if (bytes.length % 5 != 0)
			args.add("--no-plots");
		if (corrections.length > 0)
			args.add("--corrections=" + folder.write("given.csv", corrections));
		GUARD.runThreads(() -> options + " " + Drawings.shown(bytes) + Drawings.shown(corrections),
			progress -> requireWhole(resolve(args, progress), out, bytes, corrections.length > 0));
	}

	/** @return the exit status */
	private static int resolve(final List<String> args, final Progress progress) {
		final StringWriter said = new StringWriter(), complained = new StringWriter();
		final int status = KnotResolverMain.run(Engine.PIPELINE, progress, new PrintWriter(said),
			new PrintWriter(complained), args.toArray(new String[0]));
		final String err = complained.toString();
		if (err.contains("This is a bug") || err.contains("could not be written")
			|| err.contains("not enough memory"))
			throw failure(err);
		Guard.count("resolve: exit status " + status + " " + err.lines()
			.reduce((first, second) -> second).orElse("").replaceAll("\\S*/\\S*|\\d+|'.*'", "#"));
		if (status < 0 || status > 2 && !progress.isCancelled())
			throw new AssertionError("exit status " + status + ": " + err);
		if (status != 0 && err.isBlank())
			throw new AssertionError("no sentence, but exit status " + status);
		return status;
	}

	/** A result is there and complete, or nothing is; the movie is as it was. */
	private static void requireWhole(final int status, final Path out, final byte[] bytes,
		final boolean corrected) {
		if (Files.exists(out) != (status == 0))
			throw new AssertionError("exit status " + status + ", but there is "
				+ (status == 0 ? "no" : "a") + " result");
		try (Stream<Path> files = Files.list(out.getParent())) {
			final Set<String> names = files.map(f -> f.getFileName().toString())
				.collect(Collectors.toSet());
			if (names.size() != 1 + (corrected ? 1 : 0) + (status == 0 ? 1 : 0))
				throw new AssertionError("something is left: " + names);
			if (!Arrays.equals(bytes, Files.readAllBytes(out.resolveSibling("movie.tif"))))
				throw new AssertionError("the movie was changed");
			if (status == 0 && !Files.exists(out.resolve("frames.csv")))
				throw new AssertionError("the result has no frames.csv");
		} catch (final IOException e) {
			throw new UncheckedIOException(e);
		}
	}

	/** The failure that was told, at the place where it arose. */
	private static AssertionError failure(final String err) {
		final AssertionError failure = new AssertionError(err);
		failure.setStackTrace(
			err.lines().map(String::strip).filter(l -> l.startsWith("at io.github.knotresolver"))
				.map(l -> new StackTraceElement(l.substring(3).replaceFirst("\\(.*", ""), "",
					l.replaceFirst(".*\\(", "").replaceFirst("\\)", ""), -1))
				.toArray(StackTraceElement[]::new));
		return failure;
	}
}
