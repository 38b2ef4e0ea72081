package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.FitQuality;
import io.github.knotresolver.fit.Residue;
import io.github.knotresolver.model.Observation;

class FitLookTest {

	private static FitLook look(final double beyond, final double missing) {
		return new FitLook(new FitQuality(0, 0), new Residue(0, 0, 1), beyond, missing, 0);
	}

	/** Of twenty frames so many whose contour does not end with its light. */
	private static double elsewhere(final int off, final FitLook wrong) {
		return FitLook.elsewhere(
			IntStream.range(0, 20).mapToObj(t -> t < off ? wrong : look(0.2, 0.2)).toList());
	}

	@Test
	void lightBeyondAnEndAndLightMissingAtItBothTell() {
		for (final FitLook wrong : List.of(look(0.8, 0), look(0, 0.8))) {
			assertEquals(0, elsewhere(0, wrong));
			assertEquals(0, elsewhere(4, wrong), 1e-9);
			assertEquals(0.5, elsewhere(5, wrong), 1e-9);
			assertTrue(elsewhere(6, wrong) > 1 - 1e-9);
		}
	}

	/** Of ten frames so many that look like this. */
	private static double leavesOut(final int some, final FitLook like) {
		return FitLook.leavesOut(
			IntStream.range(0, 10).mapToObj(t -> t < some ? like : look(0.2, 0.2)).toList());
	}

	@Test
	void whatIsLeftOutInMostFramesTellsOfAll() {
		for (final FitLook like : List.of(look(0.8, 0), look(0, 0.8),
			new FitLook(new FitQuality(0, 0), new Residue(0.06, 0, 1), 0, 0, 0),
			new FitLook(new FitQuality(0, 0), new Residue(0, 0, 1), 0, 0, 0.06))) {
			assertEquals(0, leavesOut(5, like));
			assertEquals(1, leavesOut(6, like));
		}
		assertEquals(0, leavesOut(10,
			new FitLook(new FitQuality(0, 0), new Residue(0.04, 0.3, 2), 0.3, 0.3, 0.04)));
	}

	@Test
	void aMovieWithoutALookSaysNothing() {
		assertEquals(0, FitLook.elsewhere(Collections.emptyList()));
		assertEquals(0, FitLook.leavesOut(Collections.emptyList()));
	}

	@Test
	void anEndThatIsWrongInOtherFramesMakesEachDoubtful() {
		final FitEvidence evidence = new FitEvidence(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
			elsewhere(6, look(1, 0)), 0);
		assertTrue(FitConfidence.of(evidence) < Observation.SURE);
		assertTrue(FitConfidence.reason(evidence).contains("in other frames"));
	}
}
