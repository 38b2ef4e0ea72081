package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;

/** {@code evaluate --like} as a user types it, after a movie was simulated and resolved. */
class EvaluateLikeTest {

	private record Run(int status, String out, String err) {
	}

	@TempDir
	static Path home;

	private static Path movie;
	private static Path resolved;

	private static Run run(final Progress progress, final String... args) {
		final StringWriter stdout = new StringWriter(), stderr = new StringWriter();
		final int status = KnotResolverMain.run(Engine.PIPELINE, progress, new PrintWriter(stdout),
			new PrintWriter(stderr), args);
		return new Run(status, stdout.toString(), stderr.toString().strip());
	}

	private static Run like(final String... more) {
		final List<String> args = new ArrayList<>(
			List.of("evaluate", "--like", resolved.toString(), "--movies", "2"));
		args.addAll(List.of(more));
		return run(Progress.NONE, args.toArray(String[]::new));
	}

	@BeforeAll
	static void simulateAndResolve() {
		movie = home.resolve("movie");
		resolved = home.resolve("resolved");
		assertEquals(0,
			run(Progress.NONE, "simulate", "--out", movie.toString(), "--length", "7", "--density",
				"50", "--duration", "80", "--warm-up", "40", "--frames", "24", "--rendering",
				"optical", "--signal", "150", "--seed", "6").status);
		assertEquals(0, run(Progress.NONE, "resolve", movie.resolve("movie.tif").toString(),
			"--out", resolved.toString(), "--no-plots").status);
	}

	@Test
	void tellsHowOftenAndHowExactlyAndWritesItAll() throws IOException {
		final Path out = home.resolve("like");
		final Run run = like("--out", out.toString());
		assertEquals(0, run.status, run.err);
		assertTrue(run.out.startsWith("2 simulated movies like 'movie.tif', 24 frames each"),
			run.out);
		assertTrue(
			run.out.matches("(?s).*resolved \\(Frechet < 5 px\\) +[0-9.]+ % \\(95 % interval .*"),
			run.out);
		for (final String file : List.of("summary.txt", "movies.csv", "frames.csv",
			"resemblance.csv", "parameters.json", "comparison.png", "position_error.png",
			"position_error.svg", "dice.png", "frechet.svg"))
			assertTrue(Files.size(out.resolve(file)) > 0, file);
		assertEquals(3, Files.readAllLines(out.resolve("movies.csv")).size());
		assertEquals(1 + 2 * 24, Files.readAllLines(out.resolve("frames.csv")).size());
		final List<String> table = Files.readAllLines(out.resolve("resemblance.csv"));
		assertEquals("quantity,yours,simulated", table.get(0));
		assertTrue(table.contains("frames,24,24"), table.toString());
		for (final String quantity : List.of("length [µm]", "line width [px]", "noise [grey]",
			"peak over background [grey]")) {
			final String[] row = table.stream().filter(r -> r.startsWith(quantity + ","))
				.findFirst().orElseThrow().split(",");
			assertEquals(1, Double.parseDouble(row[2]) / Double.parseDouble(row[1]), 0.1, quantity);
		}

		assertTrue(like("--out", out.toString()).err.contains("already holds a result"));
		final List<String> before = Files.readAllLines(out.resolve("frames.csv"));
		assertEquals(0, like("--out", out.toString(), "--force", "--no-plots").status);
		assertEquals(before, Files.readAllLines(out.resolve("frames.csv")), "same seed");
		assertFalse(Files.exists(out.resolve("comparison.png")));
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = { //
		"--movies 0|--movies must be a whole number from 1 to 1000, but is 0.",
		"--movies many|--movies must be a whole number, but is 'many'.",
		"--seed 1.5|--seed must be a whole number, but is '1.5'.",
		"--movie gone.tif|--movie cannot be used: There is no file gone.tif; check the path.",
		"--truth a.csv|--like stands alone: leave out --truth and --result, or --like to compare those."})
	void wrongValuesAreOneSentenceAndStatus2(final String options, final String sentence) {
		final List<String> args = new ArrayList<>(
			List.of("evaluate", "--like", resolved.toString()));
		args.addAll(List.of(options.split(" ")));
		final Run run = run(Progress.NONE, args.toArray(String[]::new));
		assertEquals(sentence, run.err);
		assertEquals(2, run.status);
	}

	@Test
	void aFolderThatIsNoResultIsRefused() {
		final Run run = run(Progress.NONE, "evaluate", "--like", movie.toString());
		assertEquals(2, run.status);
		assertEquals("--like must be a folder that 'resolve' wrote, but " + movie
			+ " holds something else; name the folder of a resolved movie.", run.err);
		assertEquals(
			"Missing --truth TRUTH.csv and --result CONTOURS.csv; or give --like RESULT_DIR alone.",
			run(Progress.NONE, "evaluate").err);
	}

	@Test
	void aMovieThatIsGoneIsMissedInOneSentence() throws IOException {
		final Path copy = Files.createDirectory(home.resolve("copy"));
		for (final String file : List.of("parameters.json", "contours.csv", "frames.csv"))
			Files.writeString(copy.resolve(file), Files.readString(resolved.resolve(file))
				.replace("movie.tif\",\n    \"sha256\"", "moved.tif\",\n    \"sha256\""));
		final Run run = run(Progress.NONE, "evaluate", "--like", copy.toString());
		assertEquals(2, run.status);
		assertEquals(
			"--movie is missing: " + movie.resolve("moved.tif")
				+ ", which the result was made from, is gone; name the file where it is now.",
			run.err);
	}

	@Test
	void cancellingLeavesNothing() {
		final Path out = home.resolve("cancelled");
		final boolean[] stop = new boolean[1];
		final Run run = run(new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
				stop[0] |= stage.startsWith("Searching");
			}

			@Override
			public boolean isCancelled() {
				return stop[0];
			}
		}, "evaluate", "--like", resolved.toString(), "--out", out.toString());
		assertEquals(ExitStatus.CANCELLED, run.status, run.err);
		assertFalse(Files.exists(out));
	}
}
