package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.track.SceneTracks.Filament;

/** A ring and what lies within it may be one filament. */
class PartsOfOneTest {

	private static final int FRAMES = 20;

	/** A filament from one place to another, as sure in all frames. */
	private static Filament filament(final double sure, final IntFunction<Point> from,
		final IntFunction<Point> to) {
		return new Filament(false, false, 50, 0.1,
			IntStream.range(0, FRAMES)
				.mapToObj(t -> new Observation(t + 1, FrameStatus.RESOLVED, "",
					Optional.of(Polyline.of(List.of(from.apply(t), to.apply(t)))), 0, 1, 0, sure))
				.toList());
	}

	private static final Filament LINE = filament(0.99, t -> new Point(20, 30),
		t -> new Point(70, 30));

	/** One that crosses the place where the line begins, so far beside it, in its first frames. */
	private static Filament across(final double sure, final double beside, final int frames) {
		return filament(sure, t -> new Point(20 - (t < frames ? beside : 30), 10),
			t -> new Point(20 - (t < frames ? beside : 30), 60));
	}

	private static void assertStays(final Filament... filaments) {
		final List<Filament> found = PartsOfOne.doubted(List.of(filaments));
		for (int k = 0; k < filaments.length; k++)
			assertSame(filaments[k], found.get(k), "filament " + k);
	}

	@ParameterizedTest
	@ValueSource(booleans = {false, true})
	void oneThatEndsOnADoubtfulOneIsDoubtful(final boolean turned) {
		final Filament line = turned
			? filament(0.99, t -> new Point(70, 30), t -> new Point(20, 30))
			: LINE;
		final Filament other = across(0.5, 3, FRAMES - 2);
		final List<Filament> found = PartsOfOne.doubted(List.of(other, line));
		assertSame(other, found.get(0));
		for (final Observation o : found.get(1).frames()) {
			assertEquals(0.5, o.confidence());
			assertTrue(o.reason().contains("may be a part of it"), o.reason());
		}
	}

	@Test
	void oneThatEndsOnASureOneIsSure() {
		assertStays(LINE, across(0.6, 3, FRAMES));
	}

	@Test
	void oneThatIsApartFromADoubtfulOneIsSure() {
		assertStays(LINE, across(0.5, 6, FRAMES));
	}

	@Test
	void oneThatADoubtfulOnePassesIsSure() {
		assertStays(LINE, across(0.5, 3, FRAMES - 5));
	}

	@Test
	void oneThatADoubtfulOneEndsOnIsSure() {
		assertStays(LINE, filament(0.5, t -> new Point(45, 32), t -> new Point(45, 90)));
	}
}
