package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.IntFunction;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

class StrayStartTest {

	private static final double SIGMA = 1.2;

	@Test
	void aContourThatWasDrawnToASpeckBesideTheClampIsDoubted() {
		final List<Observation> frames = frames(20, t -> new Point(0, 0));
		for (final int t : new int[]{1, 2})
			frames.set(t, frames.get(t)
				.withContour(beginningAt(frames.get(t).contour().orElseThrow(), new Point(-5, 8))));
		final List<Observation> doubted = StrayStart.doubted(frames, SIGMA);
		for (int t = 0; t < frames.size(); t++) {
			final boolean strays = t == 1 || t == 2;
			assertEquals(strays ? 0.5 : 0.99, doubted.get(t).confidence(), "frame " + t);
			assertEquals(strays, doubted.get(t).reason().contains("clamped in other frames"));
			assertEquals(frames.get(t).contour(), doubted.get(t).contour());
		}
	}

	/** A speck that a third of the contours run on to: or it is the clamp, and two thirds are short. */
	@Test
	void whichOfTwoPlacesIsTheClampIsAGuess() {
		final List<Observation> frames = frames(20, t -> new Point(0, 0));
		for (int t = 0; t < 7; t++)
			frames.set(t, frames.get(t)
				.withContour(beginningAt(frames.get(t).contour().orElseThrow(), new Point(-5, 8))));
		StrayStart.doubted(frames, SIGMA).forEach(f -> {
			assertEquals(0.5, f.confidence());
			assertTrue(f.reason().contains("clamped in other frames"));
		});
	}

	@Test
	void aLineIsWiderThanWhatItsStartMayStray() {
		final List<Observation> frames = frames(20, t -> new Point(0, 0));
		frames.set(7, frames.get(7)
			.withContour(beginningAt(frames.get(7).contour().orElseThrow(), new Point(0, 5))));
		assertEquals(0.5, StrayStart.doubted(frames, SIGMA).get(7).confidence());
		assertEquals(0.99, StrayStart.doubted(frames, 3).get(7).confidence());
	}

	@Test
	void aClampGoesWithItsStage() {
		final Random random = new Random(3);
		assertBelieved(frames(60, t -> new Point(0.4 * t, 0)));
		assertBelieved(frames(60, t -> t < 50 ? new Point(0, 0) : new Point(0, 14)));
		assertBelieved(frames(60, t -> new Point(random.nextGaussian(), random.nextGaussian())));
	}

	@Test
	void fewFramesDoNotTellWhichOfThemIsWrong() {
		final List<Observation> frames = frames(4, t -> new Point(0, 0));
		frames.set(0, frames.get(0)
			.withContour(beginningAt(frames.get(0).contour().orElseThrow(), new Point(-5, 8))));
		assertBelieved(frames);
		assertTrue(StrayStart.doubted(List.of(), SIGMA).isEmpty());
	}

	private static void assertBelieved(final List<Observation> frames) {
		assertEquals(frames, StrayStart.doubted(frames, SIGMA));
	}

	/** The contour with other points before it has gone as far as it is drawn away. */
	private static Polyline beginningAt(final Polyline contour, final Point other) {
		final double[] x = contour.xs().clone(), y = contour.ys().clone();
		final int turned = 9;
		for (int i = 0; i < turned; i++) {
			final double part = 1 - (double) i / turned;
			x[i] += part * other.x();
			y[i] += part * other.y();
		}
		return Polyline.of(x, y);
	}

	/** A beating arc whose clamp is at a place in each frame. */
	private static List<Observation> frames(final int count, final IntFunction<Point> clamp) {
		final List<Observation> frames = new ArrayList<>();
		for (int t = 0; t < count; t++)
			frames.add(new Observation(t + 1, FrameStatus.RESOLVED, "",
				Optional.of(Drawn.arc(clamp.apply(t), 0.02 * Math.sin(0.7 * t))), 0, 1, 0, 0.99));
		return frames;
	}
}
