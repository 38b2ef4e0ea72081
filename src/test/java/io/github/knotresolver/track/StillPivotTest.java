package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/** Whether a filament that begins somewhere else in every frame turns around one place. */
class StillPivotTest {

	private static final int FRAMES = 40;

	/** A straight filament that turns, and begins so far beyond a place, which is carried along. */
	private static List<Chain> turning(final double late, final double perFrame,
		final IntFunction<Point> carried) {
		return IntStream.range(0, FRAMES).mapToObj(t -> {
			final double cos = Math.cos(perFrame * t), sin = Math.sin(perFrame * t),
				x = 50 + carried.apply(t).x() + late * cos,
				y = 40 + carried.apply(t).y() + late * sin;
			return Chain.along(
				Polyline.of(new double[]{x, x + 60 * cos}, new double[]{y, y + 60 * sin}), 20, 60);
		}).toList();
	}

	private static Point shaken(final int t) {
		return new Point(0.15 * (t % 3 - 1), 0.15 * (t * 7 % 5 - 2));
	}

	@ParameterizedTest
	@ValueSource(doubles = {1, 2.5})
	void itTurnsAroundAPlaceThatIsDark(final double late) {
		final Point place = StillPivot.of(turning(late, 0.15, StillPivotTest::shaken))
			.orElseThrow();
		assertEquals(0, place.distanceTo(new Point(50, 40)), 0.2);
	}

	/** Where there is light before the place, there is filament. */
	@Test
	void whatIsSeenBeforeItIsTheFilament() {
		assertEquals(Optional.empty(), StillPivot.of(turning(-1.5, 0.15, StillPivotTest::shaken)));
	}

	@Test
	void aClampThatMovesIsNone() {
		assertEquals(Optional.empty(),
			StillPivot.of(turning(1.5, 0.15, t -> new Point(0.3 * t, 0.1 * t))));
		assertEquals(Optional.empty(), StillPivot
			.of(turning(0.3, 0.15, t -> new Point(2 * (t % 3 - 1), 1.5 * (t * 7 % 5 - 2)))));
	}

	@Test
	void onlyOneThatTurnsTells() {
		assertEquals(Optional.empty(), StillPivot.of(turning(1.5, 0.005, StillPivotTest::shaken)));
		assertTrue(StillPivot.of(List.of()).isEmpty());
	}

	@Test
	void theAnchorStaysThere() {
		final AnchorPath moved = new AnchorPath(
			IntStream.range(0, FRAMES).mapToObj(t -> new Point(50 + 0.1 * t, 40)).toList(),
			new double[FRAMES]);
		final List<Chain> begun = turning(1.5, 0.15, StillPivotTest::shaken);
		final AnchorPath settled = moved.refined(begun.stream().map(Optional::of).toList());
		assertEquals(0, settled.range());
		assertEquals(0, settled.at(7).distanceTo(new Point(50, 40)), 0.2);
	}
}
