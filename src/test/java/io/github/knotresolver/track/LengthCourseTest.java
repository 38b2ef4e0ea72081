package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.track.LengthCourse.Kind;

class LengthCourseTest {

	private static final int FRAMES = 60;

	/** Lengths known in two of three frames, one of ten of them wrong. */
	private static Optional<LengthCourse> course(final IntToDoubleFunction truth,
		final double error, final long seed) {
		final Random random = new Random(seed);
		final int[] seen = IntStream.range(0, FRAMES).filter(t -> t % 3 != 0).toArray();
		final double[] known = IntStream.of(seen).mapToDouble(t -> truth.applyAsDouble(t)
			* (random.nextInt(10) == 0 ? 0.8 : 1 + error * random.nextGaussian())).toArray();
		return LengthCourse.changing(seen, known, FRAMES);
	}

	/** The same, no two wrong ones beside each other. */
	private static LengthCourse byTurns(final IntToDoubleFunction truth, final long seed) {
		final Random random = new Random(seed);
		final int[] seen = IntStream.range(0, FRAMES).filter(t -> t % 3 != 0).toArray();
		final double[] known = IntStream.range(0, seen.length)
			.mapToDouble(i -> truth.applyAsDouble(seen[i])
				* (i % 10 == seed ? 0.8 : 1 + 0.003 * random.nextGaussian()))
			.toArray();
		return LengthCourse.changing(seen, known, FRAMES).orElseThrow();
	}

	private static void assertFollows(final IntToDoubleFunction truth, final LengthCourse course,
		final String message) {
		for (int t = 0; t < FRAMES; t++)
			assertEquals(truth.applyAsDouble(t), course.of(t), 0.02 * truth.applyAsDouble(t),
				message + ", frame " + t);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
	void aLengthThatStaysIsConstantHoweverNoisy(final long seed) {
		assertTrue(course(t -> 150, 0.001, seed).isEmpty(), "seed " + seed);
		assertTrue(course(t -> 150, 0.01, seed).isEmpty(), "seed " + seed);
		assertTrue(course(t -> 150, 0.03, seed).isEmpty(), "seed " + seed);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4})
	void growthAndShrinkingAreSteady(final long seed) {
		for (final double rate : new double[]{1.2, 0.2, -0.9}) {
			final IntToDoubleFunction truth = t -> 150 + rate * t;
			final LengthCourse course = course(truth, 0.003, seed).orElseThrow();
			assertEquals(Kind.STEADY, course.kind(), "rate " + rate + ", seed " + seed);
			assertEquals(rate, course.rate(), 0.02);
			assertFollows(truth, course, "rate " + rate + ", seed " + seed);
		}
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4})
	void aBreakIsFoundAtItsFrame(final long seed) {
		final LengthCourse course = course(t -> t < 30 ? 150 : 90, 0.003, seed).orElseThrow();
		assertEquals(Kind.BROKEN, course.kind());
		assertEquals(30, course.at(), 2);
		assertEquals(150, course.of(10), 1.5);
		assertEquals(90, course.of(50), 1);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4})
	void growthUpToACatastropheIsBoth(final long seed) {
		final IntToDoubleFunction truth = t -> t < 31 ? 100 + 2 * t : 120 - t;
		final LengthCourse course = course(truth, 0.003, seed).orElseThrow();
		assertEquals(Kind.STEADY_AND_BROKEN, course.kind());
		assertEquals(31, course.at(), 4);
		assertEquals(140, course.of(20), 3);
		assertEquals(70, course.of(50), 3);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4})
	void growthRestCatastropheAndRescueArePhases(final long seed) {
		final IntToDoubleFunction truth = t -> t < 20
			? 100 + 3 * t
			: t < 30 ? 160 : t < 40 ? 160 - 5 * (t - 30) : 110 + 2 * (t - 40);
		final LengthCourse course = byTurns(truth, seed);
		assertEquals(Kind.PHASES, course.kind(), "seed " + seed);
		for (int t = 0; t < FRAMES; t++)
			assertEquals(truth.applyAsDouble(t), course.of(t), 5, "seed " + seed + ", frame " + t);
	}

	@Test
	void phasesOfALongMovieAreFollowed() {
		final int frames = 1300;
		final IntToDoubleFunction truth = t -> t < 400
			? 100 + 0.2 * t
			: t < 900 ? 180 : 180 - 0.3 * (t - 900);
		final Random random = new Random(5);
		final int[] seen = IntStream.range(0, frames).toArray();
		final double[] known = IntStream.of(seen)
			.mapToDouble(t -> truth.applyAsDouble(t) * (1 + 0.003 * random.nextGaussian()))
			.toArray();
		final LengthPhases phases = LengthPhases.of(seen, known, frames, 0.5, 20);
		assertEquals(2, phases.turns());
		for (int t = 0; t < frames; t++)
			assertEquals(truth.applyAsDouble(t), phases.lengths()[t], 2, "frame " + t);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4})
	void aSlowWaveIsNeitherConstantNorSteadyNorBroken(final long seed) {
		final IntToDoubleFunction truth = t -> 150 + 30 * Math.sin(0.15 * t);
		final Kind kind = course(truth, 0.002, seed).orElseThrow().kind();
		assertTrue(kind == Kind.WANDERING || kind == Kind.PHASES, kind + ", seed " + seed);
	}

	@ParameterizedTest
	@ValueSource(ints = {0, 1, 5})
	void fewLengthsSayNothing(final int n) {
		final int[] seen = IntStream.range(0, n).toArray();
		assertTrue(LengthCourse
			.changing(seen, IntStream.of(seen).mapToDouble(t -> 100 + 10 * t).toArray(), FRAMES)
			.isEmpty());
	}
}
