package io.github.knotresolver.evaluate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.concurrent.TimeUnit;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.EvaluationCsv;
import io.github.knotresolver.io.TruthCsv;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.Canvas;
import io.github.knotresolver.simulate.FilamentProperties;
import io.github.knotresolver.simulate.FilamentSimulator;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;
import io.github.knotresolver.simulate.MediumProperties;
import io.github.knotresolver.simulate.MotorProperties;
import io.github.knotresolver.simulate.Schedule;
import io.github.knotresolver.simulate.SimulationParameters;

/** An independent scorer, where it is at hand, says the same. */
class BenchAgreementTest {

	private static final Path SCORER = Path.of("..", "shared", "bench", "score.py");
	/** A Python with numpy, scipy and numba. */
	private static final String PYTHON = Optional.ofNullable(System.getenv("BENCH_PYTHON"))
		.orElse("python3");

	@TempDir
	private Path folder;

	@Test
	void theIndependentScorerSaysTheSame() throws IOException, InterruptedException {
		assumeTrue(Files.exists(SCORER) && isReady(),
			"skipped: the scorer in ../shared or its Python (BENCH_PYTHON) is not on this machine");
		final Path truth = folder.resolve("truth.csv"), result = folder.resolve("result.csv");
		final Path theirs = folder.resolve("theirs.csv"), ours = folder.resolve("ours.csv");
		final List<Polyline> contours = contours();
		TruthCsv.write(truth, contours);
		TruthCsv.write(result, disturbed(contours));
		final SortedMap<Integer, Polyline> judged = ContoursCsv.read(result);
		final Process process = new ProcessBuilder(PYTHON, SCORER.toString(), truth.toString(),
			result.toString(), "--json", "--per-frame", theirs.toString()).redirectErrorStream(true)
			.start();
		final String output = new String(process.getInputStream().readAllBytes());
		assertEquals(true, process.waitFor(1, TimeUnit.MINUTES));
		final Evaluation evaluation = Evaluation.of(ContoursCsv.read(truth), judged, Progress.NONE);
		compareSummaries(JsonParser.parseString(output.strip()).getAsJsonObject(),
			evaluation.summary());
		EvaluationCsv.write(ours, evaluation);
		compareRows(Files.readAllLines(theirs), Files.readAllLines(ours));
	}

	private static boolean isReady() throws InterruptedException {
		try {
			return new ProcessBuilder(PYTHON, "-c", "import numpy, scipy, numba")
				.redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
				.waitFor() == 0;
		} catch (final IOException e) {
			return false;
		}
	}

	/** A short simulation in which the filament winds up. */
	private static List<Polyline> contours() {
		final Trajectory t = new FilamentSimulator(new SimulationParameters(
			FilamentProperties.microtubule(10), MotorProperties.dynein(100), MediumProperties.WATER,
			new Schedule(120, 24, 0.01, 30), 2)).run(Progress.NONE);
		return Canvas.around(t, 0.106, 10).truth(t);
	}

	/** Shifted more and more, some shortened, some reversed, two missing. */
	private static List<Polyline> disturbed(final List<Polyline> contours) {
		final Polyline[] result = new Polyline[contours.size() - 2];
		for (int t = 0; t < result.length; t++) {
			final double shift = 0.3 * t;
			final Polyline c = contours.get(t);
			final double[] x = Arrays.stream(c.xs()).map(v -> v + shift).toArray();
			final Polyline moved = Polyline.of(x, c.ys());
			result[t] = t % 5 == 1
				? moved.head(c.length() * 0.8)
				: t % 7 == 2 ? moved.reversed() : moved;
		}
		return List.of(result);
	}

	private static void compareSummaries(final JsonObject theirs, final EvaluationSummary ours) {
		final Map<String, Number> figures = new LinkedHashMap<>();
		figures.put("frames", ours.frames());
		figures.put("frames_present", ours.framesPresent());
		figures.put("frames_with_crossings", ours.framesWithCrossings());
		figures.put("extra_result_frames", ours.extraResultFrames());
		figures.put("mean_dice", ours.meanDice());
		figures.put("mean_dice_crossing_frames", ours.meanDiceCrossingFrames());
		figures.put("median_frechet_px", ours.medianFrechet());
		figures.put("median_frechet_present_px", ours.medianFrechetPresent());
		figures.put("mean_err_px", ours.meanError());
		figures.put("mean_miss_px", ours.meanMiss());
		figures.put("median_abs_len_err_pct", ours.medianAbsoluteLengthError());
		figures.put("pct_resolved", ours.percentResolved());
		figures.put("pct_resolved_crossing_frames", ours.percentResolvedCrossingFrames());
		figures.put("pct_resolved_simple_frames", ours.percentResolvedSimpleFrames());
		figures.put("frames_flipped", ours.framesFlipped());
		figures.put("first_unresolved_frame", ours.firstUnresolvedFrame().orElse(-1));
		assertNotEquals(0, ours.framesWithCrossings(), "the filament should cross itself");
		figures.forEach((key, value) -> assertEquals(theirs.get(key).getAsDouble(),
			value.doubleValue(), 1e-9 * Math.max(1, Math.abs(value.doubleValue())), key));
	}

	private static void compareRows(final List<String> theirs, final List<String> ours) {
		assertEquals(theirs.get(0) + ",filament,result_filament", ours.get(0));
		assertEquals(theirs.size(), ours.size());
		final String[] header = theirs.get(0).split(",");
		for (int row = 1; row < ours.size(); row++) {
			final String[] a = theirs.get(row).split(","), b = ours.get(row).split(",");
			for (int i = 0; i < header.length; i++)
				assertEquals(number(a[i]), number(b[i]), 2e-5 * Math.max(1, Math.abs(number(b[i]))),
					String.format(Locale.ROOT, "%s of row %d", header[i], row));
		}
	}

	/** The scorer leaves counts of missing frames empty: not a number. */
	private static double number(final String text) {
		if (text.equals("inf"))
			return Double.MAX_VALUE;
		return text.equals("nan") ? 0 : Double.parseDouble(text);
	}
}
