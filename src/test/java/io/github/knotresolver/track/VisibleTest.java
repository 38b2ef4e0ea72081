package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Polyline;

class VisibleTest {

	private static final NormalizedFrame FRAME = new NormalizedFrame(40, 30, new double[1200]);

	private static Polyline straight(final double fromX, final double toX) {
		final double[] xy = new double[2 * 101];
		for (int i = 0; i <= 100; i++) {
			xy[2 * i] = fromX + (toX - fromX) * i / 100;
			xy[2 * i + 1] = 12;
		}
		return Drawn.line(xy);
	}

	@Test
	void aContourInsideIsWhole() {
		final Polyline inside = straight(3, 38);
		assertSame(inside, Visible.of(inside, FRAME).contour());
		assertEquals(1, Visible.of(inside, FRAME).share());
	}

	@Test
	void aContourThatLeavesEndsAtTheBorder() {
		final Visible visible = Visible.of(straight(10, 60), FRAME);
		assertEquals(39.5, visible.contour().last().x(), 0.6);
		assertEquals(29.5 / 50, visible.share(), 0.02);
		assertEquals(10, visible.contour().first().x());
	}

	/** Not at the last of its points that is in the picture, which may be most of a pixel before. */
	@Test
	void itEndsBetweenItsPoints() {
		final Visible visible = Visible.of(Drawn.line(10, 12, 38.6, 12, 41.6, 12), FRAME);
		assertEquals(39.5, visible.contour().last().x(), 0.01);
		assertEquals(29.5 / 31.6, visible.share(), 0.001);
		final Visible up = Visible.of(Drawn.line(10, 12, 10, 0.2, 12, -1.8), FRAME);
		assertEquals(-0.5, up.contour().last().y(), 0.01);
		assertEquals(10.7, up.contour().last().x(), 0.01);
	}

	@Test
	void whatComesBackInAfterTheBorderIsNotShown() {
		final Polyline back = Drawn.line(20, 12, 30, 12, 39, 12, 45, 14, 45, 18, 38, 20, 20, 20);
		final Visible visible = Visible.of(back, FRAME);
		assertEquals(12, visible.contour().last().y(), 1);
		assertTrue(visible.share() < 0.5);
	}

	@Test
	void aContourThatBeginsOutsideIsLeftAlone() {
		final Polyline outside = straight(-20, 20);
		assertSame(outside, Visible.of(outside, FRAME).contour());
	}
}
