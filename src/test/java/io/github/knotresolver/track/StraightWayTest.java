package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Polyline;

/** What lies over a line that lies still may have lent it a bend. */
class StraightWayTest {

	private static final int SIZE = 120;
	private static final double WIDTH = 3.3;
	private static final LineTables LOOK = LineTables
		.together(LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1));
	private static final Polyline ROD = rod(10, 110);

	private static double height(final double x) {
		return 50 + 0.06 * x;
	}

	private static Polyline rod(final double from, final double to) {
		return Polyline.of(new double[]{from, to}, new double[]{height(from), height(to)});
	}

	/** The rod, but so many pixels above it in its middle, as an arc of a ring is. */
	private static Polyline bent(final double most) {
		final double[] x = IntStream.rangeClosed(10, 110).asDoubleStream().toArray();
		return Polyline.of(x,
			IntStream.rangeClosed(10, 110).mapToDouble(
				i -> height(i) - (i > 30 && i < 70 ? most * Math.sin(Math.PI * (i - 30) / 40) : 0))
				.toArray());
	}

	private static Polyline found(final Polyline curve, final Polyline... lines) {
		final NormalizedFrame picture = new NormalizedFrame(SIZE, SIZE, DrawnFrames.light(SIZE,
			LOOK, Stream.of(lines).map(l -> Chain.inScene(l, l.length())).toList()));
		return new StraightWay(picture, WIDTH, 0.5).of(curve);
	}

	@Test
	void aLineGoesStraightOnWhereSomethingLentItABend() {
		final Polyline straight = found(bent(9), ROD, bent(9));
		for (int i = 0; i < straight.size(); i++)
			assertTrue(ROD.distanceTo(straight.point(i)) < 0.1, straight.point(i).toString());
		assertEquals(ROD.first(), straight.first());
		assertEquals(ROD.last(), straight.last());
	}

	@Test
	void aLineThatIsBentStaysBent() {
		assertEquals(bent(9), found(bent(9), bent(9)));
	}

	@Test
	void aWayWithADarkPlaceIsNone() {
		assertEquals(bent(9), found(bent(9), bent(9), rod(10, 46), rod(54, 110)));
	}

	@Test
	void aBendWithinTheLinesWidthIsTheLinesOwn() {
		assertEquals(bent(3), found(bent(3), ROD, bent(3)));
	}
}
