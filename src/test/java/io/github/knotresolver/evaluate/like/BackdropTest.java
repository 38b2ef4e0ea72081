package io.github.knotresolver.evaluate.like;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;

class BackdropTest {

	private static final int SIZE = 40, FRAMES = 5;

	private final byte[] pixels = new byte[SIZE * SIZE * FRAMES];
	private final List<Optional<Polyline>> contours = new ArrayList<>();

	/** A bright line that wanders down, a speck at (30, 20), a level that is 7 times the column. */
	private Backdrop backdrop() {
		for (int t = 0; t < FRAMES; t++) {
			final int row = 8 + 6 * t;
			for (int i = 0; i < SIZE * SIZE; i++)
				pixels[t * SIZE * SIZE + i] = (byte) level(i % SIZE, i / SIZE);
			for (int x = 5; x < 25; x++)
				pixels[t * SIZE * SIZE + row * SIZE + x] = (byte) 255;
			contours.add(Optional.of(Polyline.of(new double[]{5, 24}, new double[]{row, row})));
		}
		return new Backdrop(
			new Movie("m", ArrayImgs.unsignedBytes(pixels, SIZE, SIZE, FRAMES), Calibration.NONE),
			contours, 2, 1);
	}

	private static int level(final int x, final int y) {
		return x == 30 && y == 20 ? 200 : 2 * x + 3;
	}

	@Test
	void theFilamentIsGoneAndTheRestStays() {
		final Backdrop backdrop = backdrop();
		for (int t = 0; t < FRAMES; t++) {
			final double[] view = backdrop.view(t, SIZE, SIZE, new Point(0, 0), new Point(0, 0),
				false, false);
			for (int i = 0; i < view.length; i++)
				assertEquals(level(i % SIZE, i / SIZE), view[i],
					"frame " + t + ", pixel " + i % SIZE + "," + i / SIZE);
		}
	}

	@Test
	void aViewIsMovedMirroredAndGoesOnBeyondTheEdges() {
		final double[] view = backdrop().view(0, 100, 90, new Point(30, 20), new Point(50, 45),
			true, false);
		assertEquals(200, view[45 * 100 + 50], "the speck is where it is told to be");
		assertEquals(level(25, 20), view[45 * 100 + 55], "left and right are exchanged");
		assertEquals(level(39, 20), view[45 * 100 + 40], "one beyond the edge is the edge");
		assertEquals(level(38, 20), view[45 * 100 + 39], "and so on backwards");
	}
}
