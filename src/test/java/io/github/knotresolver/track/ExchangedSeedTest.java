package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/** Two gliders that cross at a small angle: their trailing ends tell that halves were exchanged. */
class ExchangedSeedTest {

	private static final int SIZE = 175, FRAMES = 20, START = 2;
	private static final double NOISE = 0.08, ANGLE = 0.14;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1));
	private static final double[] LENGTHS = {64, 48};

	/** A straight glider through the middle; the second comes from below. */
	private static Chain glider(final int k, final double lead) {
		return on(k, k, lead - LENGTHS[k], lead);
	}

	/**
	 * What runs on one track up to where they cross and on another from there.
	 *
	 * @param from arc length of its trailing end, 0 where the tracks cross
	 */
	private static Chain on(final int before, final int after, final double from, final double to) {
		final List<Point> points = new ArrayList<>();
		for (double s = from; s < to; s++)
			points.add(place(s < 0 ? before : after, s));
		points.add(place(to < 0 ? before : after, to));
		final Polyline curve = Polyline.of(points);
		return Chain.inScene(curve, curve.length());
	}

	private static Point place(final int track, final double s) {
		final double angle = track == 0 ? ANGLE : -ANGLE;
		return new Point(62 + s * Math.cos(angle), 87 + s * Math.sin(angle));
	}

	/** How far beyond the crossing a leading end is. */
	private static double lead(final int k, final int t) {
		return (k == 0 ? 14 : 9) + 5 * (t - START);
	}

	private static SceneLine seen() {
		final Random random = new Random(5);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(DrawnFrames.lit(t + 1, DrawnFrames.light(SIZE, LINE,
				List.of(glider(0, lead(0, t)), glider(1, lead(1, t)))), NOISE, random));
		return new SceneLine(LINE, frames, NOISE);
	}

	private static PricedPass mended(final SceneLine line, final PricedPass pass) {
		return new ExchangedSeed(line, SceneWeights.DEFAULT, Workers.HERE, Progress.NONE)
			.mended(pass);
	}

	private static PricedPass followed(final SceneLine line, final List<Chain> seed) {
		return PricedPass.of(
			ScenePass.from(START, seed, line, SceneWeights.DEFAULT, Workers.HERE, Progress.NONE),
			line, Workers.HERE);
	}

	@Test
	void halvesThatWereExchangedWhereAPassBeganAreGivenBack() {
		final SceneLine line = seen();
		final double[] lead = {lead(0, START), lead(1, START)};
		final PricedPass wrong = followed(line, List.of(on(0, 1, lead[0] - LENGTHS[0], lead[1]),
			on(1, 0, lead[1] - LENGTHS[1], lead[0])));
		final PricedPass right = mended(line, wrong);
		assertTrue(right.price() < wrong.price() - 0.5, wrong.price() + " " + right.price());
		for (int t = 0; t < FRAMES; t++) {
			final List<Chain> found = right.pass().chains().get(t);
			for (int k = 0; k < 2; k++) {
				final Polyline truth = glider(k, lead(k, t)).polyline();
				final Polyline nearest = found
					.stream().map(Chain::polyline).min((p, q) -> Double
						.compare(SceneSeed.distance(p, truth), SceneSeed.distance(q, truth)))
					.orElseThrow();
				assertEquals(0, SceneSeed.distance(nearest, truth), 1,
					"filament " + k + ", frame " + t);
			}
		}
	}

	@Test
	void aPassThatExplainsTheMovieStaysAsItIs() {
		final SceneLine line = seen();
		final PricedPass pass = followed(line,
			List.of(glider(0, lead(0, START)), glider(1, lead(1, START))));
		assertSame(pass, mended(line, pass));
	}
}
