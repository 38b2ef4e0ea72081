
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;

class SingleFilamentTest {

	private static Polyline line(final double... xy) {
		final double[] x = new double[xy.length / 2], y = new double[xy.length / 2];
		for (int i = 0; i < x.length; i++) {
			x[i] = xy[2 * i];
			y[i] = xy[2 * i + 1];
		}
		return Polyline.of(x, y);
	}

	@Test
	void oneObjectWithAnEndThatStaysIsAClampedFilament() {
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < 10; t++)
			frames.add(DrawnFrames.lines(t + 1, line(20, 50, 60, 40 + 3 * t, 90, 30 + 6 * t)));
		assertTrue(SingleFilament.isClampedAlone(frames));
	}

	@Test
	void aGliderIsNot() {
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < 10; t++)
			frames.add(DrawnFrames.lines(t + 1, line(10 + 4 * t, 50, 60 + 4 * t, 50)));
		assertFalse(SingleFilament.isClampedAlone(frames));
	}

	@Test
	void twoThatCrossAreNot() {
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < 10; t++)
			frames.add(DrawnFrames.lines(t + 1, line(20, 50, 90, 30 + 4 * t),
				line(60, 10, 50 + 2 * t, 95)));
		assertFalse(SingleFilament.isClampedAlone(frames));
	}

	@Test
	void whatCrossesIsOneObjectAndWhatLiesApartIsNot() {
		final List<FrameView> crossing = new ArrayList<>(), apart = new ArrayList<>();
		for (int t = 0; t < 10; t++) {
			crossing.add(DrawnFrames.lines(t + 1, line(20, 50, 90, 30 + 4 * t),
				line(60, 10, 50 + 2 * t, 95)));
			apart.add(DrawnFrames.lines(t + 1, line(20, 20, 90, 20 + t), line(20, 80, 90, 80 - t)));
		}
		assertTrue(SingleFilament.isOneObject(crossing));
		assertFalse(SingleFilament.isOneObject(apart));
	}

	@Test
	void aFilamentBesideSpecksIsMostOfAMovieAndOneOfSeveralIsNot() {
		final List<FrameView> specks = new ArrayList<>(), several = new ArrayList<>();
		for (int t = 0; t < 10; t++) {
			specks.add(DrawnFrames.lines(t + 1, line(20, 20, 90, 20 + t), line(20, 80, 40, 80),
				line(60, 70, 80, 60)));
			several.add(DrawnFrames.lines(t + 1, line(20, 20, 90, 20 + t), line(20, 80, 70, 80),
				line(30, 60, 80, 60)));
		}
		assertFalse(SingleFilament.isOneObject(specks));
		assertTrue(SingleFilament.isMostlyOneObject(specks));
		assertFalse(SingleFilament.isMostlyOneObject(several));
		assertFalse(SingleFilament.isMostlyOneObject(List.of(DrawnFrames.lines(1))));
	}
}
