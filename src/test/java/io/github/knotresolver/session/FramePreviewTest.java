package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import io.github.knotresolver.CancelledProgress;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.FilamentChoice;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/** Single frames as the program sees them: what a run would see. */
class FramePreviewTest {

	private static final Movie SAMPLE = ImageMovie.of(SampleMovie.open(), InputOptions.DEFAULT);

	/** A frame in which the filament crosses itself. */
	private static final int KNOT = 13;

	static Stream<Settings> settings() {
		final Settings threshold = Settings.DEFAULT.edit()
			.segmentation(
				Segmentation.DEFAULT.withThreshold(OptionalDouble.of(0.5)).withIterations(3))
			.build();
		return Stream.of(Settings.DEFAULT, threshold);
	}

	@ParameterizedTest
	@MethodSource("settings")
	void skeletonIsThatOfARun(final Settings settings) {
		final FramePreview preview = new FramePreview(SAMPLE);
		final List<Img<BitType>> run = FrameSkeletons.of(SAMPLE, settings, Progress.NONE);
		for (final int frame : new int[]{1, KNOT, 1}) {
			final FrameLook look = preview.look(settings, frame, Progress.NONE);
			assertEquals(frame, look.frame());
			assertArrayEquals(Pixels.bits(run.get(frame - 1)), Pixels.bits(look.skeleton()),
				"frame " + frame);
			int area = 0;
			for (final boolean bit : Pixels.bits(look.mask()))
				area += bit ? 1 : 0;
			assertEquals(area, look.area());
		}
	}

	@Test
	void contourRunsFromTheFixedEndThroughTheKnot() {
		final FramePreview preview = new FramePreview(SAMPLE);
		final FramePreview.Check check = preview.check(Settings.DEFAULT, Progress.NONE);
		assertEquals(List.of(), check.notes());
		final Point end = check.fixedEnd().orElseThrow();
		final Settings told = Settings.DEFAULT.edit().fixedEnd(Optional.of(end)).build();
		final double open = preview.look(told, 1, Progress.NONE).contours().get(0).length();
		final FrameLook knot = preview.look(told, KNOT, Progress.NONE);
		assertEquals(1, knot.contours().size());
		assertEquals(open, knot.contours().get(0).length(), 0.1 * open);
		assertTrue(knot.contours().get(0).first().distanceTo(end) < 6, "begins elsewhere");
		assertEquals(Polarity.BRIGHT, knot.polarity());
		assertTrue(
			preview.look(told.edit().filaments(FilamentChoice.ALL).build(), KNOT, Progress.NONE)
				.contours().size() >= 1);
	}

	@Test
	void aRegionIsSeenInTheWholeMoviesPixels() {
		final Region region = new Region(4, 2, 90, 50);
		final Settings part = Settings.DEFAULT.edit().region(Optional.of(region)).build();
		final FrameLook look = new FramePreview(SAMPLE).look(part, 1, Progress.NONE);
		assertEquals(SAMPLE.width(), Pixels.width(look.mask()));
		final boolean[] bits = Pixels.bits(look.skeleton());
		for (int at = 0; at < bits.length; at++)
			if (bits[at]) {
				final Point pixel = new Point(at % SAMPLE.width(), at / SAMPLE.width());
				assertTrue(look.contours().stream().anyMatch(c -> near(c, pixel)),
					"The skeleton at " + pixel + " is not where the contour is.");
			}
	}

	private static boolean near(final Polyline contour, final Point pixel) {
		for (int i = 0; i < contour.size(); i++)
			if (contour.point(i).distanceTo(pixel) < 3)
				return true;
		return false;
	}

	@Test
	void theCheckSaysWhatARunWouldSay() {
		final Settings dark = Settings.DEFAULT.edit()
			.segmentation(Segmentation.DEFAULT.withPolarity(Polarity.DARK)).build();
		assertTrue(new FramePreview(SAMPLE).check(dark, Progress.NONE).notes()
			.contains(EvidenceNotes.DARK));
	}

	@Test
	void whatDoesNotFitTheMovieIsRefusedAndCancelStops() {
		final FramePreview preview = new FramePreview(SAMPLE);
		assertThrows(UserException.class, () -> preview
			.look(Settings.DEFAULT.edit().frames(List.of(99)).build(), 1, Progress.NONE));
		assertThrows(CancelledException.class,
			() -> preview.look(Settings.DEFAULT, 1, new CancelledProgress()));
		assertEquals(1, preview.look(Settings.DEFAULT, 1, Progress.NONE).objects());
	}
}
