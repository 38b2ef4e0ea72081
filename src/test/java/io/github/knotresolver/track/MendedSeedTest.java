
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/** In the seed's frame two gliders are one line, or look like each other's halves. */
class MendedSeedTest {

	private static final int SIZE = 190, FRAMES = 30, START = 15;
	private static final double NOISE = 0.08, MIDDLE = 95, FIRST = 50, SECOND = 40, SPEED = 3;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1));

	/** A rod that begins in the middle in the seed's frame and glides away in a direction. */
	private static Chain rod(final int t, final double length, final double ux, final double uy) {
		final double from = SPEED * (t - START), to = from + length;
		return Chain.inScene(
			Drawn.line(MIDDLE + from * ux, MIDDLE + from * uy, MIDDLE + to * ux, MIDDLE + to * uy),
			length);
	}

	private static List<List<Chain>> gliders(final double ux, final double uy) {
		final List<List<Chain>> truth = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			truth.add(List.of(rod(t, FIRST, -1, 0), rod(t, SECOND, ux, uy)));
		return truth;
	}

	private static SceneLine seen(final List<List<Chain>> truth) {
		final Random random = new Random(3);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(
				DrawnFrames.lit(t + 1, DrawnFrames.light(SIZE, LINE, truth.get(t)), NOISE, random));
		return new SceneLine(LINE, frames, NOISE);
	}

	private static void assertFollowed(final List<List<Chain>> truth, final Polyline... seed) {
		final List<Chain> chains = new ArrayList<>();
		for (final Polyline curve : seed)
			chains.add(Chain.inScene(curve, curve.length()));
		final ScenePass pass = new MendedSeed(seen(truth), SceneWeights.DEFAULT, Workers.HERE,
			Progress.NONE, START).followed(chains);
		assertEquals(FRAMES, pass.chains().size());
		assertEquals(START, pass.start());
		for (int t = 0; t < FRAMES; t++) {
			final List<Chain> found = pass.chains().get(t);
			assertEquals(truth.get(t).size(), found.size());
			for (final Chain right : truth.get(t))
				assertEquals(0,
					found.stream()
						.mapToDouble(c -> SceneSeed.distance(c.polyline(), right.polyline())).min()
						.orElseThrow(),
					1.5, "frame " + t);
		}
	}

	/** Trails through noise, around which none of it is explained. */
	@Test
	void aSeedOfManyOfWhichNoneIsRightIsNotMended() {
		final List<String> tried = new ArrayList<>();
		final Progress progress = new Progress() {

			@Override
			public void report(final String what, final double done) {
				tried.add(what);
			}

			@Override
			public boolean isCancelled() {
				return false;
			}
		};
		final List<Chain> seed = new ArrayList<>();
		for (int k = 0; k < 6; k++) {
			seed.add(Chain.inScene(Drawn.line(30, 20 + 3 * k, 90, 20 + 3 * k), 60));
			new MendedSeed(seen(gliders(1, 0)), SceneWeights.DEFAULT, Workers.HERE, progress, START)
				.followed(seed);
			assertEquals(k < 4, tried.contains("Looking for filaments"), (k + 1) + " trails");
			tried.clear();
		}
	}

	@Test
	void oneLineThatPartsIsTwoFilaments() {
		assertFollowed(gliders(1, 0), Drawn.line(MIDDLE - FIRST, MIDDLE, MIDDLE + SECOND, MIDDLE));
	}

	@Test
	void aBendAtWhichALinePartsIsTwoEnds() {
		final double ux = Math.cos(0.9), uy = Math.sin(0.9);
		assertFollowed(gliders(ux, uy), Drawn.line(MIDDLE - FIRST, MIDDLE, MIDDLE, MIDDLE,
			MIDDLE + SECOND * ux, MIDDLE + SECOND * uy));
	}

	@Test
	void aSeedThatCanBeFollowedStaysAsItIs() {
		assertFollowed(gliders(1, 0), Drawn.line(MIDDLE - FIRST, MIDDLE, MIDDLE, MIDDLE),
			Drawn.line(MIDDLE, MIDDLE, MIDDLE + SECOND, MIDDLE));
		final List<List<Chain>> one = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			one.add(List.of(rod(t, FIRST, -1, 0)));
		assertFollowed(one, Drawn.line(MIDDLE - FIRST, MIDDLE, MIDDLE, MIDDLE));
	}

	@Test
	void piecesThatCrossedOthersAreExchanged() {
		final List<List<Chain>> truth = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			final double by = SPEED * (t - START);
			truth.add(List.of(Chain.inScene(Drawn.line(55 + by, 95, 135 + by, 95), 80),
				Chain.inScene(Drawn.line(95, 75 - by, 95, 115 - by), 40)));
		}
		assertFollowed(truth, Drawn.line(55, 95, 95, 95, 95, 115),
			Drawn.line(95, 75, 95, 95, 135, 95));
	}
}
