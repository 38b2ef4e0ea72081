package io.github.knotresolver.simulate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;

class RenderingTest {

	private static final int WIDTH = 40, HEIGHT = 30;
	private static final Canvas CANVAS = new Canvas(WIDTH, HEIGHT, 0.1, 0, 0, 2.5);
	private static final Polyline LINE = line(8, 15, 31, 15);
	private static final PaperRenderer SILENT = new PaperRenderer(Double.POSITIVE_INFINITY, 1);

	private static Polyline line(final double... xy) {
		final double[] x = new double[xy.length / 2], y = new double[xy.length / 2];
		for (int i = 0; i < x.length; i++) {
			x[i] = xy[2 * i];
			y[i] = xy[2 * i + 1];
		}
		return Polyline.of(x, y);
	}

	private static double[] paper(final Polyline curve, final double snr) {
		return new PaperRenderer(snr, 1).render(curve, 0, CANVAS, BitDepth.EIGHT);
	}

	private static double[] optical(final Polyline curve, final Optics optics, final int frame) {
		return new OpticalRenderer(optics, 1).render(curve, frame, CANVAS, BitDepth.SIXTEEN);
	}

	private static Optics optics(final double signal, final double bleaching) {
		return new Optics(1.5, signal, 50, 0, bleaching, 0, 1, 0);
	}

	@Test
	void thePublishedLineIsFivePixelsWideBlurredByThreeByThree() {
		final double[] image = SILENT.render(LINE, 0, CANVAS, BitDepth.EIGHT);
		final double side = Math.exp(-1 / 8.0), edge = side / (1 + 2 * side);
		final double[] profile = new double[9];
		for (int k = 0; k < 9; k++)
			profile[k] = (image[(11 + k) * WIDTH + 20] - 10) / 190;
		assertArrayEquals(new double[]{0, edge, 1 - edge, 1, 1, 1, 1 - edge, edge, 0}, profile,
			1e-12);
	}

	@Test
	void aPointOfTheSkeletonBecomesADiamond() {
		final double[] image = SILENT.render(line(20, 15, 21, 15), 0, CANVAS, BitDepth.EIGHT);
		assertEquals(10, image[12 * WIDTH + 17], 1e-12, "a corner of the square around it");
		assertEquals(200, image[15 * WIDTH + 20], 1e-9);
		final double light = Arrays.stream(image).map(v -> (v - 10) / 190).sum();
		assertEquals(18, light, 1e-9, "two diamonds of 13 pixels share 8");
	}

	@ParameterizedTest
	@EnumSource(BitDepth.class)
	void theNoiseHasThePowerThatTheRatioSays(final BitDepth depth) {
		final double[] clean = SILENT.render(LINE, 3, CANVAS, depth);
		final double mean = Arrays.stream(clean).average().orElseThrow();
		final double variance = Arrays.stream(clean).map(v -> (v - mean) * (v - mean)).average()
			.orElseThrow();
		double power = 0;
		final int frames = 40;
		for (int t = 0; t < frames; t++) {
			final double[] noisy = new PaperRenderer(10, 1).render(LINE, t, CANVAS, depth);
			for (int i = 0; i < noisy.length; i++)
				power += Math.pow(noisy[i] - clean[i], 2) / (frames * noisy.length);
		}
		assertEquals(variance / 10, power, 0.03 * variance / 10);
	}

	@Test
	void aCurveMayLeaveTheView() {
		final double[] image = paper(line(-20, -20, 60, 50), Double.POSITIVE_INFINITY);
		assertEquals(WIDTH * HEIGHT, image.length);
		assertTrue(Arrays.stream(optical(line(-20, -20, 60, 50), Optics.CLEAN, 0)).max()
			.orElseThrow() > 0);
	}

	@Test
	void lightOfCrossingStrandsAddsUp() {
		final LightField light = new LightField(WIDTH, HEIGHT, 1.5);
		light.addLine(line(2, 15, 38, 15), 1);
		assertEquals(1, light.values()[15 * WIDTH + 20], 1e-3);
		assertEquals(Math.exp(-0.5 * 4 / 2.25), light.values()[17 * WIDTH + 20], 1e-3);
		light.addLine(line(20, 2, 20, 28), 1);
		assertEquals(2, light.values()[15 * WIDTH + 20], 2e-3);
	}

	@Test
	void photonsVaryAsTheirNumberSays() {
		double sum = 0, squares = 0;
		int count = 0;
		for (int t = 0; t < 60; t++)
			for (final double v : optical(line(2, 2, 6, 2), optics(100, 1e9), t)) {
				if (count++ % (WIDTH * HEIGHT) < 10 * WIDTH)
					continue;
				sum += v;
				squares += v * v;
			}
		final double n = count - 60 * 10 * WIDTH, mean = sum / n;
		assertEquals(50, mean, 0.3);
		assertEquals(50, squares / n - mean * mean, 1.5, "Poisson: the variance is the mean");
	}

	@Test
	void bleachingFadesTheFilamentAndNotTheBackground() {
		final Optics fading = optics(1e5, 25);
		final double early = optical(LINE, fading, 0)[15 * WIDTH + 20];
		final double late = optical(LINE, fading, 10)[15 * WIDTH + 20];
		assertEquals(Math.E, early / late, 0.05);
	}

	@Test
	void othersAndSpecksShineAndGlide() {
		final Optics crowded = new Optics(1.5, 100, 20, 0, 1e9, 3, 5, 4);
		final OpticalRenderer.Bystanders b = new OpticalRenderer.Bystanders(crowded, 9);
		final LightField first = new LightField(WIDTH, HEIGHT, 1.5);
		final LightField again = new LightField(WIDTH, HEIGHT, 1.5);
		final LightField later = new LightField(WIDTH, HEIGHT, 1.5);
		b.addTo(first, 0, CANVAS);
		b.addTo(again, 0, CANVAS);
		b.addTo(later, 2, CANVAS);
		assertTrue(Arrays.stream(first.values()).max().orElseThrow() > 0.4);
		assertArrayEquals(first.values(), again.values());
		assertNotEquals(Arrays.hashCode(first.values()), Arrays.hashCode(later.values()));
	}

	@ParameterizedTest
	@EnumSource(BitDepth.class)
	void aMovieHasItsTruthItsSizeAndItsCalibration(final BitDepth depth) {
		final Trajectory trajectory = new Trajectory(List.of(line(0, 0, 2, 1), line(0, 0, 1, -2)),
			2.5);
		final Canvas canvas = Canvas.around(trajectory, 0.1, 10);
		assertEquals(2 / 0.1 + 21, canvas.width());
		assertEquals(3 / 0.1 + 21, canvas.height());
		final SimulatedMovie m = SimulatedMovie.render("m", trajectory, canvas, SILENT, depth,
			Progress.NONE);
		assertEquals(new Calibration(0.1, "µm", 2.5, "s"), m.movie().calibration());
		assertEquals(2, m.movie().size());
		assertEquals(10, m.truth().get(1).first().x(), 1e-12);
		assertEquals(30, m.truth().get(1).first().y(), 1e-12);
		assertEquals(20, m.truth().get(1).last().x(), 1e-9);
		final var pixel = m.movie().frame(1).randomAccess();
		pixel.setPosition(new int[]{10, 30});
		final double expected = (depth == BitDepth.EIGHT ? 1 : 100) * 200;
		assertEquals(expected, pixel.get().getRealDouble(), 1e-9);
	}

	@Test
	void aHugeViewIsRefused() {
		final Trajectory trajectory = new Trajectory(List.of(line(0, 0, 50, 50)), 1);
		assertEquals(
			"pixel_size 0.005 µm makes frames of 10001 x 10001 pixels, more than 40 million; choose larger pixels.",
			assertThrows(UserException.class, () -> Canvas.around(trajectory, 0.005, 0))
				.getMessage());
	}
}
