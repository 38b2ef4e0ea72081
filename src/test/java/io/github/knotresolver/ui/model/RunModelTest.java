package io.github.knotresolver.ui.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicLong;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Session;

/** What a person is told of a run, without any window. */
class RunModelTest {

	private static final long SECOND = 1_000_000_000;

	private final AtomicLong clock = new AtomicLong();
	private final List<String> told = new ArrayList<>();
	private final List<Double> fractions = new ArrayList<>();
	private boolean escaped;
	private final RunModel model = new RunModel(new Progress() {

		@Override
		public void report(final String stage, final double fraction) {
			told.add(stage);
			fractions.add(fraction);
		}

		@Override
		public boolean isCancelled() {
			return escaped;
		}
	}, clock::get);

	private String last() {
		return told.get(told.size() - 1);
	}

	@Test
	void stageFrameAndTimeLeftAreTold() {
		model.frames(120);
		model.report("Finding lines", 1 / 120.0);
		assertEquals("Finding lines: frame 1 of 120", last());
		clock.set(5 * SECOND);
		model.report("Finding lines", 1);
		// 12 % of the usual work in 5 s.
		assertEquals("Finding lines: frame 120 of 120, 37 s left", last());
		model.report("Learning what the filament looks like", 0);
		assertEquals("Learning what the filament looks like: 17 s left", last());
		clock.set(60 * SECOND);
		model.report("Fitting the proposals", 40 / 120.0);
		assertEquals("Fitting the proposals: frame 40 of 120, 41 s left", last());
		model.report("Drawing", 0.301);
		assertTrue(last().startsWith("Drawing: "), last());
	}

	@Test
	void theWholeNeverGoesBack() {
		for (final String stage : List.of("Looking at the movie", "Finding lines", "Thinning",
			"Proposing contours", "Learning what the filament looks like", "Proposing contours",
			"Unknown", "Fitting the proposals", "Following the filament"))
			for (final double part : new double[]{0, 0.5, 1})
				model.report(stage, part);
		assertEquals(fractions.stream().sorted().toList(), fractions);
		assertEquals(1, model.done(), 1e-9);
	}

	@Test
	void itStopsForTheButtonAndForEsc() {
		assertFalse(model.isCancelled());
		escaped = true;
		assertThrows(CancelledException.class, model::checkCancelled);
		escaped = false;
		model.cancel();
		assertTrue(model.isCancelled());
		model.report("Thinning", 0);
		assertEquals("Stopping", model.line());
	}

	@Test
	void contoursOfEveryFrameAreSightedBeforeTheEndInTheMoviesPixels() {
		final Movie movie = ImageMovie.of(SampleMovie.open(), InputOptions.DEFAULT);
		final Settings part = Settings.DEFAULT.edit().threads(1).frames(List.of(1, 2, 3, 4))
			.region(Optional.of(new Region(4, 2, 90, 50))).build();
		final Tracks tracks = new Session(movie, part).solve(List.of(), model);
		final Map<Integer, List<Polyline>> seen = new TreeMap<>(model.sightings());
		assertEquals(Set.of(1, 2, 3, 4), seen.keySet());
		seen.forEach((frame, contours) -> {
			assertEquals(1, contours.size());
			final Polyline found = tracks.only().frames().get(frame - 1).contour().orElseThrow();
			assertTrue(contours.get(0).at(contours.get(0).length() / 2)
				.distanceTo(found.at(found.length() / 2)) < 4, "frame " + frame);
		});
		assertEquals("4 frames right, 0 doubtful, 0 lost", RunOutcome.of(tracks).line());
	}

	@Test
	void theOutcomeCountsWhatAPersonMustLookAt() {
		final Polyline line = Polyline.of(List.of(new Point(1, 1), new Point(9, 1)));
		final Movie movie = new Movie("m", ArrayImgs.bytes(10, 10, 5), Calibration.NONE);
		final List<Observation> frames = List.of(of(1, FrameStatus.RESOLVED, line, 0.95),
			of(2, FrameStatus.RESOLVED, line, 0.5), of(3, FrameStatus.CORRECTED, line, 1),
			Observation.without(4, FrameStatus.LOST, "Dark."),
			Observation.without(5, FrameStatus.ABSENT, "Gone."));
		final FilamentTrack one = new FilamentTrack(1, Anchor.CLAMPED, Optional.empty(), 8,
			Double.NaN, frames);
		assertEquals(new RunOutcome(1, 2, 1, 1),
			RunOutcome.of(new Tracks(movie, Settings.DEFAULT, List.of(one), List.of())));
		assertEquals("2 filaments: 1 frame right, 0 doubtful, 3 lost",
			new RunOutcome(2, 1, 0, 3).line());
	}

	private static Observation of(final int frame, final FrameStatus status, final Polyline line,
		final double confidence) {
		return new Observation(frame, status, "", Optional.of(line), 0, 1, 0, confidence);
	}
}
