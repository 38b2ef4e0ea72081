
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SceneSettler.Settled;

/** Two filaments that cross at a small angle; what is behind the crossing is not equally long. */
class ExchangedHalvesTest {

	private static final int SIZE = 125, FRAMES = 14;
	private static final double NOISE = 0.05;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1));

	/** From the left to the crossing, and on to the right. */
	private static Chain chain(final boolean fromTop, final boolean toTop) {
		final double[] x = {12, 60, toTop ? 107 : 110};
		final double[] y = {fromTop ? 45 : 75, 60, toTop ? 45.3 : 75.6};
		final Polyline curve = Polyline.of(x, y);
		return Chain.along(curve, 34, curve.length());
	}

	private static SceneLine seen() {
		final double[] light = DrawnFrames.light(SIZE, LINE,
			List.of(chain(true, false), chain(false, true)));
		final Random random = new Random(4);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(DrawnFrames.lit(t + 1, light, NOISE, random));
		return new SceneLine(LINE, frames, NOISE);
	}

	/** Filaments whose other ends are exchanged between two frames. */
	private static List<Settled> exchanged(final int from, final int to) {
		final List<Settled> both = new ArrayList<>();
		for (final boolean fromTop : new boolean[]{true, false}) {
			final List<Chain> chains = new ArrayList<>();
			for (int t = 0; t < FRAMES; t++)
				chains.add(chain(fromTop, (t >= from && t < to) == fromTop));
			final double[] gap = new double[FRAMES];
			Arrays.fill(gap, 9);
			both.add(new Settled(chains, gap, Double.NaN));
		}
		return both;
	}

	private static Optional<List<Settled>> mended(final List<Settled> filaments) {
		final SceneLine line = seen();
		final ScenePass pass = ScenePass.of(filaments);
		return new ExchangedHalves(line, SceneWeights.DEFAULT, Workers.HERE, Progress.NONE)
			.mended(filaments, new SceneLengths(line, SceneWeights.DEFAULT).of(pass,
				pass.clear(line, Workers.HERE), Workers.HERE));
	}

	private static void assertMended(final List<Settled> exchanged) {
		final List<Settled> mended = mended(exchanged).orElseThrow();
		for (int k = 0; k < 2; k++) {
			final Chain right = chain(k == 0, k != 0);
			for (int t = 0; t < FRAMES; t++) {
				final Chain found = mended.get(k).chains().get(t);
				assertEquals(right.length(), found.length(), 0.3);
				assertTrue(found.farthest(right) < 1,
					"filament " + k + ", frame " + (t + 1) + ": " + found.farthest(right));
			}
		}
	}

	@Test
	void halvesThatAreExchangedFromSomeFrameOnAreGivenBack() {
		assertMended(exchanged(FRAMES / 2, FRAMES));
	}

	@Test
	void halvesThatAreExchangedUpToSomeFrameAreGivenBack() {
		assertMended(exchanged(0, FRAMES / 2));
	}

	/** No length steps: each half stays with the other one's. */
	@Test
	void halvesThatAreExchangedInAllFramesAreGivenBack() {
		assertMended(exchanged(0, FRAMES));
	}

	@Test
	void filamentsThatGoStraightThroughEachOtherStay() {
		assertTrue(mended(exchanged(0, 0)).isEmpty());
	}
}
