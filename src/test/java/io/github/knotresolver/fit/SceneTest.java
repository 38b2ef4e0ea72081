
package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SceneTest {

	private static final int SIZE = 80;

	private static LineTables line(final LineModel.Kind kind) {
		return LineTables.together(LineModel.uniform(kind, 1.4, 1));
	}

	private static NormalizedFrame dark() {
		return new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
	}

	private static Chain wild(final Random random) {
		final double[] theta = new double[20];
		theta[0] = 6 * random.nextDouble();
		for (int i = 1; i < theta.length; i++)
			theta[i] = theta[i - 1] + 0.5 * random.nextGaussian();
		return new Chain(80 * random.nextDouble(), 80 * random.nextDouble(), theta, 3);
	}

	private static Chain straight(final double x, final double y, final double angle) {
		final double[] theta = new double[14];
		Arrays.fill(theta, angle);
		return new Chain(x, y, theta, 3);
	}

	@ParameterizedTest
	@EnumSource
	void takingAChainOutUndoesAddingItExactly(final LineModel.Kind kind) {
		for (long seed = 1; seed <= 10; seed++) {
			final Random random = new Random(seed);
			final List<Chain> chains = new ArrayList<>();
			for (int k = 0; k < 5; k++)
				chains.add(wild(random));
			final Scene scene = new Scene(dark(), line(kind), chains);
			final double[] before = scene.picture().clone();
			for (int step = 0; step < 20; step++) {
				final int k = random.nextInt(5);
				scene.take(k);
				scene.put(k, wild(random));
				scene.take(k);
				scene.put(k, chains.get(k));
				// The same chain is not drawn anew.
				if (step % 2 == 0)
					scene.take(k);
				scene.put(k, scene.chain(k));
			}
			assertArrayEquals(before, scene.picture(), 0, kind + ", seed " + seed);
		}
	}

	@ParameterizedTest
	@EnumSource
	void theOrderInWhichChainsAreDrawnDoesNotMatter(final LineModel.Kind kind) {
		final Random random = new Random(3);
		final List<Chain> chains = new ArrayList<>();
		for (int k = 0; k < 6; k++)
			chains.add(wild(random));
		final double[] forwards = new Scene(dark(), line(kind), chains).picture().clone();
		Collections.reverse(chains);
		assertArrayEquals(forwards, new Scene(dark(), line(kind), chains).picture(), 0);
	}

	@Test
	void lightAddsUpWhereStrandsCrossOrSaturates() {
		final List<Chain> cross = List.of(straight(20, 40, 0), straight(40, 20, Math.PI / 2));
		final int centre = 40 * SIZE + 40;
		assertEquals(2, new Scene(dark(), line(LineModel.Kind.ADDITIVE), cross).picture()[centre],
			0.02);
		assertEquals(1, new Scene(dark(), line(LineModel.Kind.SATURATING), cross).picture()[centre],
			0.02);
	}

	@ParameterizedTest
	@EnumSource
	void aChainIsFittedWhileTheOthersAreDrawn(final LineModel.Kind kind) {
		final Chain one = straight(18, 36, 0.15), other = straight(30, 60, -0.9);
		final Scene truth = new Scene(dark(), line(kind), List.of(one, other));
		final Scene scene = new Scene(new NormalizedFrame(SIZE, SIZE, truth.picture()), line(kind),
			List.of(one.shifted(1, -1.5), other));
		scene.take(0);
		final Fit fit = scene.window(List.of(scene.chain(0))).fit(scene.chain(0), Optional.empty(),
			new FitSettings(4, 0, 0, 30, 1e-6, false));
		assertTrue(fit.chain().distance(one) < 0.1, () -> kind + ": " + fit.chain().distance(one));
	}

	@Test
	void anEndThatTurnedIsGrownAnew() {
		final double[] theta = new double[20];
		for (int i = 15; i < 20; i++)
			theta[i] = theta[i - 1] + 0.45;
		final Chain turned = new Chain(10, 40, theta, 3);
		final Scene truth = new Scene(dark(), line(LineModel.Kind.ADDITIVE), List.of(turned));
		final Scene scene = new Scene(new NormalizedFrame(SIZE, SIZE, truth.picture()),
			line(LineModel.Kind.ADDITIVE));
		final Chain straight = new Chain(10, 40, new double[20], 3);
		final List<Chain> grown = scene.window(List.of(straight)).regrown(straight, 6,
			new FitSettings(4, 0, 0, 30, 1e-6, false));
		assertTrue(grown.get(0).distance(turned) < 1, () -> "" + grown.get(0).distance(turned));
	}
}
