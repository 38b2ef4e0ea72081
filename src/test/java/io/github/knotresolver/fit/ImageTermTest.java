
package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import io.github.knotresolver.geometry.Polyline;

class ImageTermTest {

	private static final int SIZE = 60;
	private static final int LINKS = 24;

	@ParameterizedTest
	@EnumSource
	void normalEquationsAgreeWithFiniteDifferences(final LineModel.Kind kind) {
		for (long seed = 1; seed <= 5; seed++) {
			final Random random = new Random(seed);
			final LineModel model = model(kind);
			final NormalizedFrame frame = noisyFrame(model, random);
			final double[] x = new double[LINKS + 1], y = new double[LINKS + 1];
			loop(random).nodes(x, y);
			final ImageTerm term = ImageTerm.of(frame, model, LINKS);
			final NodeSystem system = new NodeSystem(LINKS + 1, LINKS);
			linearize(term, x, y, system);
			double scale = 0;
			for (final double v : system.vector)
				scale = Math.max(scale, Math.abs(v));
			for (int k = 0; k <= 2 * LINKS + 1; k++) {
				final double[] moved = k % 2 == 0 ? x : y;
				final double step = 0.002, at = moved[k / 2];
				moved[k / 2] = at + step;
				final double up = term.evaluate(x, y, LINKS, false);
				moved[k / 2] = at - step;
				final double down = term.evaluate(x, y, LINKS, false);
				moved[k / 2] = at;
				assertEquals((up - down) / (2 * step), -2 * system.vector[k], 0.05 * scale,
					kind + ", seed " + seed + ", unknown " + k);
			}
		}
	}

	@ParameterizedTest
	@EnumSource
	void normalEquationsDoNotDependOnWhatWasLookedAtBefore(final LineModel.Kind kind) {
		final Random random = new Random(11);
		final LineModel model = model(kind);
		final NormalizedFrame frame = noisyFrame(model, random);
		final double[] x = new double[LINKS + 1], y = new double[LINKS + 1];
		final ImageTerm term = ImageTerm.of(frame, model, LINKS);
		loop(random).nodes(x, y);
		term.evaluate(x, y, LINKS, true);
		loop(random).shifted(1.3, -0.4).nodes(x, y);
		term.evaluate(x, y, LINKS, false);
		term.draw(x, y, LINKS, new Patch(0, 0, SIZE, SIZE), new double[SIZE * SIZE]);
		loop(random).nodes(x, y);
		final NodeSystem used = new NodeSystem(LINKS + 1, LINKS),
			fresh = new NodeSystem(LINKS + 1, LINKS);
		linearize(term, x, y, used);
		linearize(ImageTerm.of(frame, model, LINKS), x, y, fresh);
		assertArrayEquals(fresh.vector, used.vector);
		for (int i = 0; i < fresh.size; i++)
			for (int j = i; j < fresh.size; j++)
				assertEquals(fresh.get(i, j), used.get(i, j), kind + ", " + i + ", " + j);
	}

	@ParameterizedTest
	@EnumSource
	void reducedSystemIsTheChainRule(final LineModel.Kind kind) {
		final Random random = new Random(7);
		final LineModel model = model(kind);
		final NormalizedFrame frame = noisyFrame(model, random);
		final Chain chain = loop(random);
		final double[] x = new double[LINKS + 1], y = new double[LINKS + 1];
		chain.nodes(x, y);
		final NodeSystem nodes = new NodeSystem(LINKS + 1, LINKS);
		linearize(ImageTerm.of(frame, model, LINKS), x, y, nodes);
		final ReducedSystem reduced = new ReducedSystem(LINKS, true);
		reduced.reduce(nodes, x, y, chain.linkLength());
		final double[][] jacobian = jacobian(x, y, chain.linkLength());
		for (int a = 0; a < LINKS + 3; a++) {
			double right = 0;
			for (int i = 0; i < nodes.size; i++)
				right += jacobian[i][a] * nodes.vector[i];
			assertEquals(right, reduced.vector[a], 1e-9, "right-hand side " + a);
			for (int b = a; b < LINKS + 3; b++) {
				double sum = 0;
				for (int i = 0; i < nodes.size; i++)
					for (int j = 0; j < nodes.size; j++)
						sum += jacobian[i][a] * full(nodes, i, j) * jacobian[j][b];
				assertEquals(sum, reduced.matrix[a][b], 1e-7 * (1 + Math.abs(sum)),
					"entry " + a + "," + b);
			}
		}
	}

	@Test
	void theRecursionAlongTheChainSolvesTheDenseSystem() {
		for (long seed = 1; seed <= 10; seed++) {
			final Random random = new Random(seed);
			final LineModel model = model(LineModel.Kind.SATURATING);
			final NormalizedFrame frame = noisyFrame(model, random);
			final Chain chain = loop(random);
			final double[] x = new double[LINKS + 1], y = new double[LINKS + 1];
			chain.nodes(x, y);
			final double[][] steps = new double[2][];
			for (int s = 0; s < 2; s++) {
				final NodeSystem nodes = new NodeSystem(LINKS + 1, s == 0 ? LINKS : 1);
				linearize(ImageTerm.of(frame, model, LINKS), x, y, nodes);
				final StepSystem system = s == 0
					? new ReducedSystem(LINKS, false)
					: new ChainSystem(LINKS);
				system.reduce(nodes, x, y, chain.linkLength());
				system.addStart(3, 0.4, -0.7);
				for (int i = 1; i < LINKS; i++)
					system.addBend(i, 0.3 + 0.01 * i, 0.02 * i);
				for (int i = 0; i < LINKS; i++)
					system.addAngle(i, 0.05, 0.1 - 0.01 * i);
				steps[s] = system.solve(0.01);
			}
			assertArrayEquals(steps[0], steps[1], 1e-8, "seed " + seed);
		}
	}

	@Test
	void crossingIsBrighterOnlyInTheAdditiveModel() {
		final Chain cross = Chain.along(
			Polyline.of(new double[]{10, 50, 50, 30, 30}, new double[]{30, 30, 10, 10, 50}), 60,
			120);
		final double[] x = new double[61], y = new double[61];
		cross.nodes(x, y);
		final double[] picture = new double[SIZE * SIZE];
		final NormalizedFrame dark = new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
		ImageTerm.of(dark, LineModel.uniform(LineModel.Kind.ADDITIVE, 1.5, 1), 60).draw(x, y, 60,
			Patch.of(dark), picture);
		assertEquals(2, picture[30 * SIZE + 30], 0.05);
		assertEquals(1, picture[30 * SIZE + 20], 0.01);
		ImageTerm.of(dark, LineModel.uniform(LineModel.Kind.SATURATING, 1.5, 1), 60).draw(x, y, 60,
			Patch.of(dark), picture);
		assertEquals(1, picture[30 * SIZE + 30], 0.05);
	}

	@Test
	void endsThatALensBlursAreThoseOfLightThatAddsUp() {
		final Chain rod = Chain.along(Polyline.of(new double[]{15.3, 44.8}, new double[]{20, 37}),
			LINKS, 34.05);
		final double[] x = new double[LINKS + 1], y = new double[LINKS + 1];
		rod.nodes(x, y);
		final NormalizedFrame dark = new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
		final double[][] pictures = new double[2][SIZE * SIZE];
		for (int k = 0; k < 2; k++)
			ImageTerm
				.of(dark, LineModel.uniform(
					k == 0 ? LineModel.Kind.ADDITIVE : LineModel.Kind.BRIGHTEST, 1.5, 1), LINKS)
				.draw(x, y, LINKS, Patch.of(dark), pictures[k]);
		assertArrayEquals(pictures[0], pictures[1], 0.01);
	}

	private static void linearize(final ImageTerm term, final double[] x, final double[] y,
		final NodeSystem nodes) {
		term.evaluate(x, y, LINKS, true);
		term.linearize(x, y, nodes);
	}

	private static LineModel model(final LineModel.Kind kind) {
		return LineModel.uniform(kind, 1.7, kind == LineModel.Kind.ADDITIVE ? 1 : 1.5);
	}

	/**
	 * A picture of a chain that is not quite the one that is fitted, with noise.
	 */
	private static NormalizedFrame noisyFrame(final LineModel model, final Random random) {
		final double[] x = new double[LINKS + 1], y = new double[LINKS + 1];
		loop(random).nodes(x, y);
		final double[] picture = new double[SIZE * SIZE];
		ImageTerm.of(new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]), model, LINKS).draw(x,
			y, LINKS, new Patch(0, 0, SIZE, SIZE), picture);
		for (int i = 0; i < picture.length; i++)
			picture[i] += 0.05 * random.nextGaussian();
		return new NormalizedFrame(SIZE, SIZE, picture);
	}

	/** A chain with a loop, a little different each time. */
	private static Chain loop(final Random random) {
		final double[] theta = new double[LINKS];
		for (int i = 0; i < LINKS; i++)
			theta[i] = 0.1 * random.nextGaussian() + (i < 8 ? 0 : (i - 8) * 0.45);
		return new Chain(15 + random.nextDouble(), 40 + random.nextDouble(), theta, 3);
	}

	private static double full(final NodeSystem nodes, final int i, final int j) {
		return i / 2 <= j / 2 ? nodes.get(i, j) : nodes.get(j, i);
	}

	private static double[][] jacobian(final double[] x, final double[] y, final double h) {
		final double[][] j = new double[2 * LINKS + 2][LINKS + 3];
		for (int i = 0; i <= LINKS; i++) {
			j[2 * i][0] = 1;
			j[2 * i + 1][1] = 1;
			for (int k = 0; k < i; k++) {
				j[2 * i][k + 2] = y[k] - y[k + 1];
				j[2 * i + 1][k + 2] = x[k + 1] - x[k];
			}
			j[2 * i][LINKS + 2] = (x[i] - x[0]) / h;
			j[2 * i + 1][LINKS + 2] = (y[i] - y[0]) / h;
		}
		return j;
	}
}
