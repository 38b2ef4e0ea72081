package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

class StartMakerTest {

	private static final Point CLAMP = new Point(10, 20);
	private static final Polyline SHORT = Polyline.of(new double[]{12, 40}, new double[]{20, 20});

	@Test
	void whatIsMissingIsAddedStraightOnAtTheTip() {
		final Chain chain = StartMaker.start(SHORT, CLAMP, 20, 36);
		assertEquals(CLAMP, chain.start());
		assertEquals(36, chain.length(), 1e-9);
		assertEquals(0, chain.polyline().last().distanceTo(new Point(46, 20)), 1e-9);
	}

	@Test
	void whatIsTooMuchIsCutOff() {
		final Chain chain = StartMaker.start(SHORT, CLAMP, 20, 15);
		assertEquals(0, chain.polyline().last().distanceTo(new Point(25, 20)), 1e-9);
	}

	@Test
	void theSmoothContourOfABendIsAsLongAsTheArcItWasFittedTo() {
		// A chain that is fitted to a circle of radius R has its nodes 2/3 of a sagitta outside.
		final double radius = 12, step = 0.25,
			outside = radius + 2.0 / 3 * radius * (1 - Math.cos(step / 2));
		final double[] x = new double[13], y = new double[13];
		for (int i = 0; i < x.length; i++) {
			x[i] = 50 + outside * Math.cos(step * i);
			y[i] = 50 + outside * Math.sin(step * i);
		}
		final Polyline nodes = Polyline.of(x, y);
		final Polyline contour = Chain.along(nodes, 12, nodes.length()).contour();
		final Polyline middle = contour.reversed().head(contour.length() - 6).reversed()
			.head(contour.length() - 12);
		for (int i = 0; i < middle.size(); i++)
			assertEquals(radius, middle.point(i).distanceTo(new Point(50, 50)), 0.02, "point " + i);
	}

	@Test
	void aFilamentThatLeavesThePictureGoesStraightOn() {
		final Polyline seen = Polyline
			.of(List.of(new Point(0, 10), new Point(10, 10), new Point(20, 10)));
		final Chain chain = StartMaker.leaving(seen, new Point(0, 10), 50, 60);
		assertEquals(60, chain.length(), 1e-9);
		assertEquals(0, chain.tip().distanceTo(new Point(60, 10)), 1e-6);
		assertEquals(15, StartMaker.leaving(seen, new Point(0, 10), 50, 15).length(), 1e-9);
	}
}
