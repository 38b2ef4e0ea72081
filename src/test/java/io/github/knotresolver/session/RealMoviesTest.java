package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.LengthModel;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;

/**
 * Real movies, nothing told: a stabilised microtubule keeps its length, never jumps,
 * and stays where it is clamped.
 */
class RealMoviesTest {

	private static final Path DATA = Path.of("..", "shared", "data", "real");

	/** Largest step of the fixed end between neighbouring frames in pixels. */
	private static final double STEADY = 0.5;

	@ParameterizedTest
	@CsvSource({"dyn1, 42, 0.006", "branchDemo, 36, 0.012"})
	void isResolvedWithNothingTold(final String name, final int frames,
		final double lengthVariation) {
		final Path file = DATA.resolve(name + ".tif");
		assumeTrue(Files.exists(file), "Not here: " + file);
		final Tracks tracks = new Session(ImageMovie.of(ImageFile.open(file), InputOptions.DEFAULT),
			Settings.DEFAULT).solve(List.of(), Progress.NONE);
		final Consistency consistency = Consistency.of(tracks.only().frames());
		assertAll(name, () -> assertEquals(frames, tracks.resolved(), "frames with a contour"),
			() -> assertEquals(List.of(), consistency.off(), "frames of another length"),
			() -> assertEquals(List.of(), consistency.jumps(), "frames where the turning jumps"),
			() -> assertTrue(consistency.lengthVariation() <= lengthVariation,
				"length varies by " + consistency.lengthVariation()),
			() -> assertTrue(consistency.endStep() <= STEADY,
				"fixed end steps by " + consistency.endStep() + " px"));
	}

	/** The fixed end is told where no filament is. */
	@Test
	void aPieceLikeASpotIsNoContour() {
		final Path file = DATA.resolveSibling("faults").resolve("crash_mt6.tif");
		assumeTrue(Files.exists(file), "Not here: " + file);
		final Tracks tracks = new Session(ImageMovie.of(ImageFile.open(file), InputOptions.DEFAULT),
			new Settings.Builder().fixedEnd(Optional.of(new Point(12, 8)))
				.lengthModel(LengthModel.FREE).build())
			.solve(List.of(), Progress.NONE);
		for (final Observation frame : tracks.only().frames())
			assertTrue(
				frame.contour().isEmpty()
					|| frame.confidence() < Observation.SURE && frame.contour().get().length() > 8,
				frame.toString());
	}
}
