
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

/** Straight filaments and pieces beside them, of lines that are 1.5 px wide. */
class SpecksTest {

	private static final double SIGMA = 1.5;

	private static final int FRAMES = 10;

	private static final List<Chain> FILAMENT = still(20, 30, 80);

	private static List<Chain> still(final double x, final double y, final double length) {
		return IntStream.range(0, FRAMES).mapToObj(t -> straight(x, y, length)).toList();
	}

	private static Chain straight(final double x, final double y, final double length) {
		return Chain.along(Polyline.of(new double[]{x, x + length}, new double[]{y, y}), 20,
			length);
	}

	private static List<Observation> observed() {
		return IntStream.range(0, FRAMES).mapToObj(t -> new Observation(t + 1, FrameStatus.RESOLVED,
			"", Optional.of(FILAMENT.get(t).contour()), 0, 1, 0, 0.99)).toList();
	}

	private static double confidence(final List<Chain> beside) {
		final List<Observation> said = Specks.of(List.of(FILAMENT, beside), SIGMA).doubted(FILAMENT,
			observed());
		final double first = said.get(0).confidence();
		said.forEach(o -> assertEquals(first, o.confidence()));
		assertEquals(first > 0.9, said.get(0).reason().isEmpty());
		return first;
	}

	@Test
	void aPieceOfLineThatStaysAtTheFilamentMayBeAPartOfIt() {
		assertEquals(0.5, confidence(still(102, 30, 15)));
		assertEquals(0.5, confidence(still(50, 33, 15)));
	}

	@Test
	void aFilamentIsInPiecesIfAPieceOfLineStaysBesideIt() {
		assertTrue(Specks.of(List.of(FILAMENT, still(102, 30, 15)), SIGMA).stayBeside(FILAMENT));
		assertFalse(Specks.of(List.of(FILAMENT, still(120, 30, 15)), SIGMA).stayBeside(FILAMENT));
		assertFalse(Specks.of(List.of(FILAMENT), SIGMA).stayBeside(FILAMENT));
	}

	@Test
	void whatIsApartOrASpotOrPassesByIsNone() {
		assertEquals(0.99, confidence(still(104, 30, 15)));
		assertEquals(0.99, confidence(still(50, 33, 7)));
		assertEquals(0.99, confidence(
			IntStream.range(0, FRAMES).mapToObj(t -> straight(60, 3 + 7 * t, 15)).toList()));
	}

	@Test
	void theyAreCountedInOneSentence() {
		final Specks none = Specks.of(List.of(FILAMENT), SIGMA);
		assertTrue(none.notes().isEmpty());
		assertFalse(none.has(FILAMENT));
		final List<Chain> piece = still(102, 30, 15);
		final Specks one = Specks.of(List.of(FILAMENT, piece), SIGMA);
		assertTrue(one.has(piece));
		assertFalse(one.has(FILAMENT));
		assertTrue(one.notes().get(0).startsWith("1 object was modelled but not counted"));
	}
}
