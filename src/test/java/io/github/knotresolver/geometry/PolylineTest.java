package io.github.knotresolver.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;

class PolylineTest {

	private static final Polyline CORNER = Polyline.of(new double[]{0, 3, 3},
		new double[]{0, 0, 4});

	@Test
	void arcLengthRunsAlongTheCorner() {
		assertEquals(7, CORNER.length());
		assertEquals(new Point(3, 1), CORNER.at(4));
		assertEquals(CORNER.first(), CORNER.at(-1));
		assertEquals(CORNER.last(), CORNER.at(99));
	}

	@Test
	void headKeepsTheFirstPart() {
		assertEquals(new Point(3, 2), CORNER.head(5).last());
		assertEquals(5, CORNER.head(5).length(), 1e-12);
		assertEquals(CORNER, CORNER.head(7));
	}

	@Test
	void resamplingKeepsBothEndsAndStepsEvenlyAlongTheArc() {
		for (long seed = 1; seed <= 20; seed++) {
			final Random random = new Random(seed);
			final int n = 2 + random.nextInt(30);
			final Polyline curve = Polyline.of(random.doubles(n, 0, 50).toArray(),
				random.doubles(n, 0, 50).toArray());
			final Polyline even = curve.resampled(0.7);
			assertEquals(curve.first(), even.first(), "seed " + seed);
			assertEquals(curve.last(), even.last(), "seed " + seed);
			for (int i = 0; i < even.size(); i++)
				assertEquals(0,
					curve.at(curve.length() * i / (even.size() - 1)).distanceTo(even.point(i)),
					1e-9, "seed " + seed + ", point " + i);
		}
	}

	@Test
	void reversingTwiceChangesNothing() {
		assertEquals(CORNER, CORNER.reversed().reversed());
		assertEquals(CORNER.last(), CORNER.reversed().first());
	}

	@Test
	void whatIsNoCurveIsRefused() {
		assertThrows(IllegalArgumentException.class, () -> Polyline.of(List.of()));
		assertThrows(IllegalArgumentException.class,
			() -> Polyline.of(new double[]{1}, new double[]{Double.NaN}));
		assertThrows(IllegalArgumentException.class, () -> CORNER.resampled(0));
	}

	@Test
	void crossingsAreWhereStrandsPassThroughEachOther() {
		final Polyline loop = Polyline.of(new double[]{0, 10, 10, 5, 5},
			new double[]{5, 5, 0, 0, 9});
		assertEquals(List.of(new Point(5, 5)), Crossings.of(loop));
		final Polyline touching = Polyline.of(new double[]{0, 10, 10, 5, 5},
			new double[]{5, 5, 0, 0, 5});
		assertEquals(List.of(), Crossings.of(touching));
	}
}
