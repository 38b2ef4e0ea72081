package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/** Two strands of one filament that cross twice, or only touch. */
class StrandExchangeTest {

	private static final LineModel LINE = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.5, 1);

	private static final double WIDTH = 3.5;

	private static double lower(final double x) {
		return 60;
	}

	private static double arch(final double x, final double height) {
		return 52 + height * Math.sin(Math.PI * (x - 20) / 80);
	}

	/**
	 * A straight strand, a wide turn, and a strand that runs the same way (or back) over the first
	 * one's middle.
	 *
	 * @param height of the second strand's arch in pixels; above 8 it reaches the first
	 * @param crossing whether they cross; if not, each keeps to its side
	 */
	static Chain coil(final double height, final boolean crossing, final boolean back) {
		final List<double[]> points = new ArrayList<>();
		for (int x = 20; x <= 100; x++)
			points.add(new double[]{x, crossing ? lower(x) : Math.max(lower(x), arch(x, height))});
		final double[] turn = back
			? new double[]{108, 63, 116, 68, 118, 60, 114, 53, 108, 50}
			: new double[]{112, 58, 118, 45, 114, 28, 100, 16, 60, 10, 24, 16, 8, 30, 6, 42, 11,
				49};
		for (int i = 0; i < turn.length; i += 2)
			points.add(new double[]{turn[i], turn[i + 1]});
		for (int k = 0; k <= 80; k++) {
			final double x = back ? 100 - k : 20 + k;
			points.add(
				new double[]{x, crossing ? arch(x, height) : Math.min(lower(x), arch(x, height))});
		}
		points.add(back ? new double[]{10, 47} : new double[]{110, 47});
		final double[] xy = points.stream().flatMapToDouble(Arrays::stream).toArray();
		final Polyline curve = Drawn.line(xy);
		return Chain.along(curve, FilamentEstimator.links(curve.length()), curve.length());
	}

	private static double nearest(final List<Polyline> contours, final Chain truth) {
		return contours.stream()
			.mapToDouble(c -> Chain.along(c, truth.links(), truth.length()).farthest(truth)).min()
			.orElse(Double.POSITIVE_INFINITY);
	}

	@Test
	void strandsThatTouchTwiceMayCrossTwiceWhicheverWayTheyRun() {
		for (final boolean back : new boolean[]{false, true}) {
			final Chain touching = coil(14, false, back), crossing = coil(14, true, back);
			assertTrue(touching.farthest(crossing) > 5);
			assertTrue(nearest(new StrandExchange(touching, WIDTH).contours(), crossing) < 2.5,
				"to cross, " + back);
			assertTrue(nearest(new StrandExchange(crossing, WIDTH).contours(), touching) < 2.5,
				"to touch, " + back);
		}
	}

	@Test
	void nothingIsExchangedWhereNothingTouchesOrNothingIsSeenBetween() {
		assertEquals(List.of(), new StrandExchange(coil(2, true, false), WIDTH).contours());
		assertEquals(List.of(), new StrandExchange(coil(8.3, true, false), WIDTH).contours());
		assertEquals(List.of(),
			new StrandExchange(Chain.along(Drawn.line(0, 0, 100, 20), 45, 100), WIDTH).contours());
	}

	/** One frame of the filament, of which only a wrong fit is known. */
	private static FitPools wrong(final Chain truth, final Chain wrong) {
		final LineTables tables = LineTables.together(LINE);
		final FrameView frame = DrawnFrames.lit(1, DrawnFrames.light(130, tables, List.of(truth)),
			0.1, new Random(5));
		final NormalizedFrame light = frame.light();
		final FilamentEstimate estimate = new FilamentEstimate(LINE, 1, truth.length(), 0.1,
			truth.start(), false);
		final Fit fit = new FilamentFitter(light, LINE, truth.links(), Optional.of(truth.start()),
			FitSettings.DEFAULT).fit(wrong, Optional.empty());
		return new FitPools(List.of(frame), List.of(light),
			new FilamentCourse(estimate, AnchorPath.still(truth.start(), 1),
				LengthCourse.constant(truth.length(), 1), 0.1, FitSettings.DEFAULT.stiffness()),
			List.of(new CandidateSet(List.of(), false)), List.of(List.of(fit)),
			FitSettings.DEFAULT);
	}

	@Test
	void aFrameOfWhichOnlyTheExchangedContourIsKnownGetsTheOther() {
		final Chain truth = coil(14, true, false);
		final FitPools pools = wrong(truth, coil(14, false, false));
		assertTrue(pools.fits().get(0).get(0).chain().farthest(truth) > 4, "the fit is wrong");
		final List<Fit> fits = pools.withExchanges(Workers.HERE, Progress.NONE).fits().get(0);
		assertTrue(fits.stream().anyMatch(f -> f.chain().farthest(truth) < 1.5),
			fits.stream().map(f -> "" + f.chain().farthest(truth)).toList().toString());
	}
}
