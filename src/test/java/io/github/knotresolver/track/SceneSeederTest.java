
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineModel.Kind;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

class SceneSeederTest {

	private static final int SIZE = 130;
	private static final double NOISE = 0.05;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(Kind.ADDITIVE, 1.4, 1));

	/** Two filaments, one after the other on the same track: the first goes ahead. */
	private static List<Chain> inARow(final int t) {
		return List.of(rod(63 + 2 * t, 60, 0, 40), rod(20, 60, 0, 40));
	}

	private static Chain rod(final double x, final double y, final double angle,
		final double length) {
		return Chain.inScene(Polyline.of(new double[]{x, x + length * Math.cos(angle)},
			new double[]{y, y + length * Math.sin(angle)}), length);
	}

	private static FrameView frame(final List<Chain> chains) {
		return DrawnFrames.lit(1, DrawnFrames.light(SIZE, LINE, chains), NOISE, new Random(7));
	}

	@Test
	void withOneFilamentKnownTheOtherIsToldApart() {
		final List<Chain> truth = List.of(rod(62, 60, 0, 40), rod(22, 60, 0, 40));
		final SceneSeeder seeder = new SceneSeeder(LINE, SceneWeights.DEFAULT);
		final List<Chain> alone = seeder.chains(frame(truth), List.of());
		assertEquals(1, alone.size(), "a frame cannot tell two filaments end to end from one");
		assertEquals(80, alone.get(0).length(), 1);
		final List<Chain> together = seeder.chains(frame(truth), List.of(truth.get(0)));
		assertEquals(2, together.size());
		assertSame(truth.get(0), together.get(0));
		assertEquals(40, together.get(1).length(), 1);
		assertTrue(SceneSeed.distance(truth.get(1).polyline(), together.get(1).polyline()) < 1);
	}

	@Test
	void whatManyFramesConfirmIsKnownWhereAllItsLightIsExplained() {
		final List<FrameView> frames = new ArrayList<>();
		final List<List<Chain>> followed = new ArrayList<>();
		for (int t = 0; t < 12; t++) {
			final List<Chain> truth = inARow(t);
			frames.add(frame(truth));
			// The second one is lost from the seventh frame on.
			followed.add(List.of(truth.get(0), rod(20, 60 + (t < 6 ? 0 : 9), 0, 40)));
		}
		final SceneLine line = new SceneLine(LINE, frames, NOISE);
		final ScenePool pool = new ScenePool(line);
		final PricedPass pass = PricedPass.of(new ScenePass(0, followed), line, Workers.HERE);
		assertTrue(pool.isEmpty());
		assertEquals(false, pool.add(pass));
		assertEquals(2, pool.known(0).size());
		assertEquals(1, pool.known(8).size());
		assertSame(followed.get(8).get(0), pool.known(8).get(0));
		assertEquals(0.5, pool.coverage(8), 0.03);
		pool.add(pass);
		assertEquals(1, pool.known(8).size(), "what two passes have is known once");
	}

	@Test
	void withSomeKnownTheNextStartIsWellApartInTimeFromTheFirst() {
		final List<Chain> truth = List.of(rod(20, 30, 0, 40), rod(60, 60, 0, 40),
			rod(30, 90, 0, 40));
		final List<FrameView> frames = Collections.nCopies(20, frame(truth));
		final SceneLine line = new SceneLine(LINE, frames, NOISE);
		final ScenePool pool = new ScenePool(line);
		pool.add(PricedPass.of(new ScenePass(3, Collections.nCopies(20, List.of(truth.get(0)))),
			line, Workers.HERE));
		final SceneSeeds seeds = new SceneSeeds(line, SceneWeights.DEFAULT);
		final List<SceneSeed> looks = IntStream.of(3, 1, 5, 18)
			.mapToObj(t -> new SceneSeed(t, truth.subList(0, 1), new boolean[]{true}, 0.3))
			.toList();
		final Optional<SceneSeed> next = seeds.next(looks, looks.subList(0, 1), pool, Workers.HERE,
			Progress.NONE);
		assertEquals(18, next.orElseThrow().frame());
		assertEquals(3, next.orElseThrow().chains().size());
		final Optional<SceneSeed> last = seeds.next(looks.subList(0, 3), looks.subList(0, 1), pool,
			Workers.HERE, Progress.NONE);
		assertEquals(1, last.orElseThrow().frame(), "if there is none, one that is near");
	}
}
