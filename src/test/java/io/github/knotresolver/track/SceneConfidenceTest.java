package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

class SceneConfidenceTest {

	private static final SceneConfidence CLEAR = new SceneConfidence(50, 0, 0, 1, 0);

	@Test
	void nothingThatSpeaksAgainstAContourRaisesItsConfidence() {
		assertEquals(1, CLEAR.value(), 1e-9);
		assertEquals("", CLEAR.reason());
		assertLess(new SceneConfidence(0.5, 0, 0, 1, 0), "another course");
		assertLess(new SceneConfidence(50, 1, 0, 1, 0), "not explained");
		assertLess(new SceneConfidence(50, 0, 0.2, 1, 0), "in the dark");
		assertLess(new SceneConfidence(50, 0, 0, 6, 0), "farther than usual");
		assertLess(new SceneConfidence(50, 0, 0, 1, 0.4), "in many other frames");
		assertEquals(1, new SceneConfidence(50, 0, 0, 1, 0.2).value(), 1e-9);
	}

	private static void assertLess(final SceneConfidence doubtful, final String why) {
		assertTrue(doubtful.value() < 0.9, doubtful.toString());
		assertTrue(doubtful.reason().contains(why), doubtful.reason());
	}

	@Test
	void noContourIsSurerThanThoseShortlyBeforeAndAfterIt() {
		final double[] confidence = {1, 1, 1, 0.4, 1, 0.95, 1, 1, 1, 1, 1, 1};
		final List<Observation> together = SceneConfidence.together(IntStream
			.range(0, confidence.length).mapToObj(t -> seen(t + 1, confidence[t])).toList());
		final double[] expected = {0.4, 0.4, 0.4, 0.4, 0.4, 0.4, 0.4, 0.4, 0.4, 0.95, 0.95, 1};
		for (int t = 0; t < expected.length; t++)
			assertEquals(expected[t], together.get(t).confidence(), "frame " + (t + 1));
		assertTrue(together.get(2).reason().startsWith("Doubtful"), together.get(2).reason());
		assertEquals("", together.get(11).reason());
	}

	@Test
	void framesWithoutAContourSayNothingOfTheirNeighbours() {
		final List<Observation> frames = List.of(seen(1, 1),
			Observation.without(2, FrameStatus.LOST, "No light."), seen(3, 0.8));
		final List<Observation> together = SceneConfidence.together(frames);
		assertEquals(0.8, together.get(0).confidence());
		assertEquals(frames.get(1), together.get(1));
	}

	private static Observation seen(final int frame, final double confidence) {
		return new Observation(frame, FrameStatus.RESOLVED, "",
			Optional.of(Polyline.of(new double[]{0, 9}, new double[]{0, 0})), 0, 1, 0, confidence);
	}
}
