package io.github.knotresolver.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.ToDoubleBiFunction;

import org.junit.jupiter.api.Test;

/** Beads and lines that are drawn, a strand's brightness 100. */
class RoundSpotsTest {

	private static final int SIZE = 80;

	private static final double SIGMA = 1.4, STRAND = 100;

	private static float[] picture(final List<ToDoubleBiFunction<Integer, Integer>> lights) {
		final float[] pixels = new float[SIZE * SIZE];
		for (int i = 0; i < pixels.length; i++)
			for (final ToDoubleBiFunction<Integer, Integer> light : lights)
				pixels[i] += (float) light.applyAsDouble(i % SIZE, i / SIZE);
		return pixels;
	}

	private static ToDoubleBiFunction<Integer, Integer> bead(final double x, final double y,
		final double height) {
		final double s = 1.3 * SIGMA;
		return (u, v) -> height * Math.exp(-((u - x) * (u - x) + (v - y) * (v - y)) / (2 * s * s));
	}

	/** A line through a point in a direction, endless, or from there on. */
	private static ToDoubleBiFunction<Integer, Integer> line(final double x, final double y,
		final double angle, final boolean endless) {
		return (u, v) -> {
			final double along = (u - x) * Math.cos(angle) + (v - y) * Math.sin(angle),
				across = (v - y) * Math.cos(angle) - (u - x) * Math.sin(angle);
			final double out = endless ? 0 : Math.min(0, along);
			return STRAND * Math.exp(-(across * across + out * out) / (2 * SIGMA * SIGMA));
		};
	}

	private static RoundSpots.Found in(final List<ToDoubleBiFunction<Integer, Integer>> lights) {
		return RoundSpots.in(picture(lights), SIZE, SIGMA, STRAND);
	}

	private static void assertTakenOff(final List<ToDoubleBiFunction<Integer, Integer>> beads,
		final List<ToDoubleBiFunction<Integer, Integer>> lines, final double within) {
		final List<ToDoubleBiFunction<Integer, Integer>> all = new ArrayList<>(beads);
		all.addAll(lines);
		final RoundSpots.Found found = in(all);
		assertEquals(beads.size(), found.count());
		final float[] truth = picture(beads);
		for (int i = 0; i < truth.length; i++)
			assertEquals(truth[i], found.light()[i], within * STRAND,
				"at " + i % SIZE + ", " + i / SIZE);
	}

	@Test
	void aBeadIsTakenOffWhole() {
		assertTakenOff(List.of(bead(40.3, 31.7, 150)), List.of(), 0.12);
	}

	@Test
	void aBeadAtTheBorderIs() {
		assertTakenOff(List.of(bead(0.4, 60, 150)), List.of(), 0.15);
	}

	@Test
	void whatIsBesideABeadIsLeft() {
		assertTakenOff(List.of(bead(30, 30, 150), bead(39.5, 34, 180)), List.of(), 0.15);
	}

	@Test
	void aLineUnderABeadIsLeft() {
		assertTakenOff(List.of(bead(40, 40, 150)), List.of(line(40, 40, 0.4, true)), 0.3);
	}

	@Test
	void linesAreNoSpots() {
		assertEquals(0, in(List.of(line(40, 40, 0.4, true))).count());
	}

	@Test
	void whereLinesCrossIsNoSpot() {
		assertEquals(0, in(List.of(line(40, 40, 0.4, true), line(40, 40, 1.9, true))).count());
	}

	/** Around it the filament turns, so that only its beginning stays. */
	@Test
	void theFixedEndIsNoSpot() {
		final float[] end = new float[SIZE * SIZE];
		Arrays.fill(end, Float.MAX_VALUE);
		for (int k = 0; k < 8; k++) {
			final float[] frame = picture(List.of(line(40, 40, k * Math.PI / 4, false)));
			for (int i = 0; i < end.length; i++)
				end[i] = Math.min(end[i], frame[i]);
		}
		assertTrue(end[40 * SIZE + 40] > 0.9 * STRAND, "it is bright");
		assertEquals(0, RoundSpots.in(end, SIZE, SIGMA, STRAND).count());
	}

	@Test
	void aWideHazeIsNoSpot() {
		assertEquals(0,
			in(List.of((u, v) -> 300
				* Math.exp(-((u - 40.) * (u - 40) + (v - 40.) * (v - 40)) / (2 * 15 * 15))))
				.count());
	}

	@Test
	void aStillPictureIsWhatLinesMoveOver() {
		final Random random = new Random(3);
		final List<float[]> frames = new ArrayList<>();
		for (int t = 0; t < 32; t++) {
			final float[] frame = picture(List.of(bead(40, 40, 150), line(40, 8 + 2 * t, 0, true)));
			for (int i = 0; i < frame.length; i++)
				frame[i] += (float) (10 * random.nextGaussian());
			frames.add(frame);
		}
		final float[] still = StillPicture.of(frames), truth = picture(List.of(bead(40, 40, 150)));
		double off = 0, squares = 0;
		for (int i = 0; i < still.length; i++) {
			off += (still[i] - truth[i]) / still.length;
			squares += Math.pow(still[i] - truth[i], 2) / still.length;
		}
		assertEquals(0, off, 3, "less than a third of a frame's noise");
		assertTrue(Math.sqrt(squares) < 5, "half of a frame's noise at most: " + squares);
	}
}
