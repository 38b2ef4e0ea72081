package io.github.knotresolver.evaluate.like;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.BitDepth;
import io.github.knotresolver.simulate.Canvas;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;
import io.github.knotresolver.simulate.FrameRenderer;
import io.github.knotresolver.simulate.OpticalRenderer;
import io.github.knotresolver.simulate.Optics;
import io.github.knotresolver.simulate.PaperRenderer;
import io.github.knotresolver.simulate.SimulatedMovie;

class AppearanceMeterTest {

	private static SimulatedMovie loops(final FrameRenderer renderer, final BitDepth depth) {
		return curves(renderer, depth, 3.2);
	}

	/** Pixels of 0.1 µm; a curve, turned a little each frame, that loops if told so. */
	private static SimulatedMovie curves(final FrameRenderer renderer, final BitDepth depth,
		final double loop) {
		final List<Polyline> curves = new ArrayList<>();
		for (int t = 0; t < 8; t++) {
			final double[] x = new double[200], y = new double[200];
			for (int i = 0; i < 200; i++) {
				final double s = i / 199.0;
				final double cx = 9 * (s - 0.5) + loop * Math.sin(2 * Math.PI * s);
				final double cy = 4 * Math.cos(2 * Math.PI * s);
				x[i] = cx * Math.cos(0.3 * t) - cy * Math.sin(0.3 * t);
				y[i] = cx * Math.sin(0.3 * t) + cy * Math.cos(0.3 * t);
			}
			curves.add(Polyline.of(x, y));
		}
		final Trajectory trajectory = new Trajectory(curves, 1);
		return SimulatedMovie.render("loops", trajectory, Canvas.around(trajectory, 0.1, 25),
			renderer, depth, Progress.NONE);
	}

	private static Appearance measure(final SimulatedMovie movie) {
		return AppearanceMeter.of(movie.movie(), movie.truth().stream().map(Optional::of).toList(),
			Progress.NONE);
	}

	@ParameterizedTest
	@ValueSource(doubles = {1.2, 1.8, 2.6})
	void anOpticalMovieGivesBackWidthBrightnessAndNoise(final double sigma) {
		final Optics optics = new Optics(sigma, 200, 50, 3, Double.POSITIVE_INFINITY, 0, 0, 0);
		final Appearance look = measure(loops(new OpticalRenderer(optics, 5), BitDepth.SIXTEEN));
		assertEquals(2.355 * sigma, look.width(), 0.08 * 2.355 * sigma, "width");
		assertEquals(50, look.background(), 1, "background");
		assertEquals(200, look.peak(), 12, "peak");
		assertEquals(Math.sqrt(50 + 9), look.noise(), 0.4, "noise");
		assertEquals(Math.sqrt(250 + 9), look.noiseOnLine(), 3, "noise on the line");
		assertFalse(look.saturating(), "crossings are brighter");
		for (final double b : look.along())
			assertEquals(1, b, 0.12, "brightness along");
	}

	@Test
	void thePublishedRenderingSaturates() {
		final Appearance look = measure(loops(new PaperRenderer(15, 3), BitDepth.EIGHT));
		assertTrue(look.saturating());
		assertEquals(190, look.peak(), 10);
		assertEquals(look.noise(), look.noiseOnLine(), 0.35 * look.noise());
		assertFalse(look.range().clipped());
	}

	@Test
	void withoutCrossingsTheShapeOfTheTopTells() {
		assertTrue(measure(curves(new PaperRenderer(15, 3), BitDepth.EIGHT, 0)).saturating());
		assertFalse(
			measure(curves(new OpticalRenderer(Optics.CLEAN, 3), BitDepth.EIGHT, 0)).saturating());
	}

	@Test
	void aClippedMovieIsKnownAsClipped() {
		final FrameRenderer bright = (curve, frame, canvas, depth) -> {
			final double[] image = new OpticalRenderer(Optics.CLEAN, 1).render(curve, frame, canvas,
				BitDepth.SIXTEEN);
			for (int i = 0; i < image.length; i++)
				image[i] *= 5;
			return image;
		};
		final Appearance look = measure(loops(bright, BitDepth.EIGHT));
		assertTrue(look.range().clipped());
		assertEquals(255, look.range().highest());
		assertTrue(look.profile().at(0) > look.peak(), "brighter than can be seen");
	}

	@Test
	void aFlatMovieHasNoLine() {
		final SimulatedMovie movie = loops(new OpticalRenderer(Optics.CLEAN, 2), BitDepth.EIGHT);
		final List<Optional<Polyline>> elsewhere = movie.truth().stream()
			.map(c -> Optional.of(Polyline.of(new double[]{2, 9}, new double[]{2, 2}))).toList();
		final Movie named = new Movie("m.tif", movie.movie().frames(), Calibration.NONE);
		final String message = assertThrows(UserException.class,
			() -> AppearanceMeter.of(named, elsewhere, Progress.NONE)).getMessage();
		assertTrue(message.startsWith("Along the contours 'm.tif' is not brighter"), message);
	}
}
