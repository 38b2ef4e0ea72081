package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.evaluate.EvaluationSummary;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;

/** The sample movie, whose truth is known, with nothing told. */
class SampleTest {

	private static final String TRUTH = "/io/github/knotresolver/sample/knotted-filament-truth.csv";

	/** Mean distance of the contour to the true curve, in pixels. */
	private static final double EXACT = 0.3;

	@TempDir
	private Path folder;

	@Test
	void everyFrameIsResolved() throws IOException {
		final SortedMap<Integer, Polyline> found = new TreeMap<>();
		resolve(2).only().frames()
			.forEach(f -> f.contour().ifPresent(c -> found.put(f.frame(), c)));
		final SortedMap<Integer, Polyline> truth = truth();
		final EvaluationSummary scores = Evaluation.of(truth, found, Progress.NONE).summary();
		assertEquals(truth.size(), scores.framesPresent(), "frames with a contour");
		assertEquals(100, scores.percentResolved(),
			"percent resolved; first that is not: " + scores.firstUnresolvedFrame());
		assertTrue(scores.framesWithCrossings() >= 10,
			scores.framesWithCrossings() + " frames with crossings");
		assertTrue(scores.meanError() < EXACT, "mean error " + scores.meanError() + " px");
	}

	@Test
	void sameBytesWhateverTheNumberOfThreads() throws IOException {
		final byte[] one = contours(1);
		assertTrue(one.length > 1000, "contours were written");
		assertArrayEquals(one, contours(2), "on 2 threads");
		assertArrayEquals(one, contours(8), "on 8 threads");
	}

	private byte[] contours(final int threads) throws IOException {
		final Path file = folder.resolve(threads + ".csv");
		ContoursCsv.write(file, MeasuredTracks.of(resolve(threads), Progress.NONE));
		return Files.readAllBytes(file);
	}

	private static Tracks resolve(final int threads) {
		final Movie movie = ImageMovie.of(SampleMovie.open(), InputOptions.DEFAULT);
		final Settings parameters = RunOptions.parse(Map.of("threads", "" + threads))
			.parameters(movie);
		return new Session(movie, parameters).solve(List.of(), Progress.NONE);
	}

	private SortedMap<Integer, Polyline> truth() throws IOException {
		final Path copy = folder.resolve("truth.csv");
		try (InputStream in = SampleTest.class.getResourceAsStream(TRUTH)) {
			Files.copy(in, copy);
		}
		return ContoursCsv.read(copy);
	}
}
