package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.model.Settings.LengthModel;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/** What a bend costs in noise. */
class FilamentLearnerTest {

	private static final double LENGTH = 80;

	/** The price of bending that is learned from a movie cut off at a height, in strands. */
	private static double stiffness(final LineModel model, final double noise,
		final double height) {
		final List<Chain> truth = DrawnMovie.waves(8, LENGTH, 1.2);
		final LineTables line = LineTables.together(model);
		final Random random = new Random(5);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < truth.size(); t++)
			frames.add(cutOff(
				DrawnFrames.lit(t + 1,
					DrawnFrames.light(DrawnMovie.SIZE, line, List.of(truth.get(t))), noise, random),
				height));
		final AnchorPath ends = AnchorPath.still(truth.get(0).start(), frames.size());
		final List<CandidateSet> first = frames.stream()
			.map(f -> TrailCandidates.DEFAULT.generate(
				CandidateQuery.of(f.graph(), truth.get(0).start(), OptionalDouble.empty()),
				Progress.NONE))
			.toList();
		return new FilamentLearner(EnumSet.of(model.kind()), LengthModel.AUTO, Workers.HERE,
			Progress.NONE).look(frames, first, ends, truth.get(0).start(), OptionalDouble.empty())
			.orElseThrow().course().stiffness();
	}

	private static FrameView cutOff(final FrameView frame, final double height) {
		final double[] pixels = Arrays.stream(frame.light().pixels()).map(p -> Math.min(p, height))
			.toArray();
		final NormalizedFrame light = new NormalizedFrame(DrawnMovie.SIZE, DrawnMovie.SIZE, pixels);
		final double[] heights = new double[Double.isFinite(height) ? pixels.length : 0];
		Arrays.fill(heights, height);
		return new FrameView(frame.frame(), light.withCeiling(heights), frame.mask(),
			frame.graph());
	}

	@ParameterizedTest
	@CsvSource({"0.05, 0.9", "0.15, 1.25", "0.2, 2.2"})
	void aBendCostsAShareOfTheNoise(final double noise, final double price) {
		assertEquals(price, stiffness(LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), noise,
			Double.POSITIVE_INFINITY), 0.15 * price);
	}

	@ParameterizedTest
	@ValueSource(doubles = {0.15, 0.2})
	void wherePartOfAStrandWasCutOffItsShareOfTheNoiseIsNotKnown(final double noise) {
		assertEquals(FitSettings.DEFAULT.stiffness(),
			stiffness(LineModel.uniform(LineModel.Kind.SATURATING, 1.6, 3), noise, 0.85));
	}
}
