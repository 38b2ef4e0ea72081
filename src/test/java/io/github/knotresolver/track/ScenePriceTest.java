
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

class ScenePriceTest {

	private static final int FRAMES = 6;

	private final List<FrameView> frames = new ArrayList<>();
	private final List<Polyline> first = new ArrayList<>(), second = new ArrayList<>();
	private final SceneResolver resolver;

	/** Two lines that cross. */
	ScenePriceTest() {
		for (int t = 0; t < FRAMES; t++) {
			first.add(Drawn.line(15, 50, 55, 50 + t, 95, 50).resampled(1));
			second.add(Drawn.line(30 + t, 15, 60, 95).resampled(1));
			frames.add(DrawnFrames.lines(t + 1, first.get(t), second.get(t)));
		}
		resolver = new SceneResolver(frames, Set.of(LineModel.Kind.values()), Workers.HERE,
			Progress.NONE);
	}

	private double price(final List<List<Polyline>> filaments) {
		final List<List<Polyline>> byFrame = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			final int frame = t;
			byFrame.add(filaments.stream().map(f -> f.get(frame)).toList());
		}
		return resolver.price(byFrame, filaments.size());
	}

	@Test
	void oneOfTwoFilamentsLeavesTheOthersLight() {
		assertTrue(price(List.of(first, second)) < 0.5 * price(List.of(first)));
		assertTrue(price(List.of(first)) < price(List.of()));
	}

	@Test
	void halvesOfAFilamentCostMoreThanTheWhole() {
		final List<Polyline> begin = first.stream().map(c -> c.head(40)).toList();
		final List<Polyline> rest = first.stream()
			.map(c -> c.reversed().head(c.length() - 40).reversed()).toList();
		final double whole = price(List.of(first, second));
		assertTrue(whole < price(List.of(begin, rest, second)));
		assertEquals(SceneTuning.PER_FILAMENT, price(List.of(begin, rest, second)) - whole, 1.5);
	}
}
