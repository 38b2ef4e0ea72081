package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.track.OpenFrames.Seen;

/** Whether a fixed end moves, where hardly any frame shows it. */
class FitPoolsTest {

	private static final double NOISE = 0.7;

	private static FitPools with(final double... energies) {
		final FilamentEstimate estimate = new FilamentEstimate(
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.5, 1), 1, 50, 0.1, new Point(0, 0), false);
		return new FitPools(List.of(), List.of(),
			new FilamentCourse(estimate, AnchorPath.still(new Point(0, 0), energies.length),
				LengthCourse.constant(50, energies.length), NOISE, 1),
			List.of(), Arrays.stream(energies).mapToObj(e -> List.of(fit(e), fit(e + 3))).toList(),
			FitSettings.DEFAULT);
	}

	private static Fit fit(final double energy) {
		return new Fit(Chain.along(Drawn.line(0, 9, 50, 9), 10, 50), 0, energy, 1);
	}

	@Test
	void theCheapestFitOfEachFrameCounts() {
		assertEquals(-30, with(-10, -20, 5).price(), 1e-9);
	}

	@Test
	void anEndStaysUnlessMovingExplainsMoreThanNoise() {
		final FitPools moving = with(-10, -20), alike = with(-9.5, -20), worse = with(-10, -17);
		assertSame(alike, moving.orStill(alike));
		assertSame(moving, moving.orStill(worse));
	}

	private static OpenFrames open(final int frames) {
		return new OpenFrames(IntStream.range(0, frames)
			.mapToObj(t -> new Seen(t, fit(0).chain(), true, true, false)).toList());
	}

	@Test
	void skeletonsAloneSayThatAnEndMovesIfHardlyAnyFrameIsOpen() {
		final AnchorPath moving = new AnchorPath(
			IntStream.range(0, 20).mapToObj(t -> new Point(t, 0)).toList(), new double[20]);
		assertTrue(moving.isDoubtful(open(2)));
		assertFalse(moving.isDoubtful(open(12)));
		assertFalse(AnchorPath.still(new Point(3, 3), 20).isDoubtful(open(2)));
	}
}
