
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.AnchorChoice;

class FilamentEndsTest {

	private static Chain rod(final double x, final double y, final double angle) {
		return Chain.inScene(Polyline.of(new double[]{x, x + 40 * Math.cos(angle)},
			new double[]{y, y + 40 * Math.sin(angle)}), 40);
	}

	@Test
	void aGliderRunsFromItsTrailingToItsLeadingEnd() {
		final List<Chain> chains = new ArrayList<>();
		for (int t = 0; t < 10; t++)
			chains.add(rod(20 + 2 * t, 50, 0));
		final FilamentEnds ends = FilamentEnds.of(chains, AnchorChoice.AUTO);
		assertFalse(ends.clamped());
		assertFalse(ends.reversed());
		assertEquals(18, ends.slid(), 1e-9);
		assertTrue(FilamentEnds.of(chains.stream().map(Chain::reversed).toList(),
			AnchorChoice.AUTO).reversed());
	}

	@Test
	void theEndThatStaysComesFirstAlsoIfTheStageDrifts() {
		final List<Chain> chains = new ArrayList<>();
		for (int t = 0; t < 30; t++)
			chains.add(rod(50 + 0.4 * t, 50, 1.2 * Math.sin(t)).reversed());
		final FilamentEnds ends = FilamentEnds.of(chains, AnchorChoice.AUTO);
		assertTrue(ends.clamped());
		assertTrue(ends.reversed());
		assertFalse(FilamentEnds.of(chains, AnchorChoice.FREE).clamped());
	}
}
