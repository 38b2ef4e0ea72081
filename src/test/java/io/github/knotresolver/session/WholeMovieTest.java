package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.IntStream;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import io.github.knotresolver.CancelledProgress;
import io.github.knotresolver.contour.DiscreteFrechet;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.CandidateMethod;
import io.github.knotresolver.model.Settings.FilamentChoice;
import io.github.knotresolver.model.Settings.LengthModel;
import io.github.knotresolver.model.Settings.ResolverMethod;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

class WholeMovieTest {

	private static final double LENGTH = 90;
	private static final double NOISE = 0.06;

	/** Frames with this amplitude cross themselves now and then. */
	private static final double KNOTTED = 3.6;

	private static final LineModel GAUSSIAN = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1);

	@ParameterizedTest
	@EnumSource(names = {"SATURATING", "ADDITIVE"})
	void resolvesKnotsWithNothingTold(final LineModel.Kind kind) {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(30, LENGTH, KNOTTED), List.of(),
			LineModel.uniform(kind, 1.6, kind == LineModel.Kind.ADDITIVE ? 1 : 1.6), NOISE, 21);
		final Tracks result = resolve(drawn, Settings.DEFAULT);
		assertTrue(result.only().frames().stream().anyMatch(f -> f.crossings() > 0),
			"no frame crosses itself");
		assertFollows(drawn, result, Set.of());
		assertEquals(LENGTH, result.only().length(), 0.01 * LENGTH);
		assertEquals(0, result.only().fixedEnd().orElseThrow().distanceTo(new Point(22.4, 55.3)),
			1);
	}

	/** As in the published movies, seven pixels wide, and as bright at its edge as in its middle. */
	@Test
	void aWideLineThatIsFlatOnTopKeepsItsKnots() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(30, LENGTH, KNOTTED), List.of(),
			LineModel.uniform(LineModel.Kind.SATURATING, 3, 3), 0.1, 24);
		final Tracks result = resolve(drawn, Settings.DEFAULT);
		assertFollows(drawn, result, Set.of());
		assertEquals(LENGTH, result.only().length(), 0.01 * LENGTH);
	}

	/** Of moving clouds half as bright as the filament nothing is right as several filaments, either. */
	@Test
	void aClampedFilamentInCloudsIsNotTakenToPieces() {
		final int frames = 16, size = DrawnMovie.SIZE;
		final DrawnMovie clear = DrawnMovie.draw(DrawnMovie.waves(frames, LENGTH, 2), List.of(),
			GAUSSIAN, 0.5, 25);
		final float[] pixels = new float[frames * size * size];
		for (int t = 0; t < frames; t++) {
			final double[] frame = clear.frame(t).pixels();
			for (int i = 0; i < frame.length; i++)
				pixels[t * frame.length + i] = (float) (frame[i]
					+ 0.5 * Math.sin(i % size / 4.0 + t) * Math.sin(i / size / 4.0 - t));
		}
		final Tracks result = new Session(
			new Movie("clouds", ArrayImgs.floats(pixels, size, size, frames), Calibration.NONE),
			Settings.DEFAULT).solve(List.of(), Progress.NONE);
		assertEquals(LENGTH, result.only().length(), 0.03 * LENGTH);
		assertTrue(result.only().frames().stream()
			.allMatch(f -> f.contour().isEmpty() || f.confidence() < 0.9
				|| DiscreteFrechet.distance(clear.truth().get(f.frame() - 1).resampled(1),
					f.contour().orElseThrow().resampled(1)) < 5));
	}

	@Test
	void aFilamentThatWindsUpDoesNotSeemToBrighten() {
		final List<Chain> chains = IntStream.range(0, 24)
			.mapToObj(t -> DrawnMovie.winding(3.2 * t, 75, 7)).toList();
		final DrawnMovie drawn = DrawnMovie.draw(chains, List.of(), GAUSSIAN, NOISE, 31);
		assertFollows(drawn, resolve(drawn, Settings.DEFAULT), Set.of());
	}

	@Test
	void aFilamentThatSlidesFarBetweenFramesIsFollowed() {
		final List<Chain> chains = IntStream.range(0, 5)
			.mapToObj(t -> DrawnMovie.winding(16 * t, 80, 9)).toList();
		final DrawnMovie drawn = DrawnMovie.draw(chains, List.of(), GAUSSIAN, NOISE, 32);
		final Tracks result = resolve(drawn, Settings.DEFAULT);
		assertEquals(0, result.only().fixedEnd().orElseThrow().distanceTo(new Point(22.4, 55.3)),
			1);
		assertFollows(drawn, result, Set.of());
	}

	@Test
	void aFilamentInStrongNoiseKeepsItsLength() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(20, LENGTH, 2), List.of(),
			GAUSSIAN, 0.42, 33);
		final Tracks result = resolve(drawn, Settings.DEFAULT);
		assertFollows(drawn, result, Set.of());
		assertEquals(LENGTH, result.only().length(), 0.02 * LENGTH);
	}

	@Test
	void aForeignFilamentThatTouchesForTenFramesDoesNotCaptureTheContour() {
		final List<Chain> chains = DrawnMovie.waves(30, LENGTH, 0.9);
		final List<List<Chain>> foreign = new ArrayList<>();
		for (int t = 0; t < chains.size(); t++) {
			// Comes from below, touches the filament's middle in frames 11 to 20, goes away.
			final Point at = chains.get(t).polyline().at(LENGTH / 2);
			final double away = t < 10 ? 12 + 2 * (10 - t) : t < 20 ? 0 : 12 + 2 * (t - 20);
			foreign.add(List.of(Chain.along(Polyline.of(new double[]{at.x() - 14, at.x() + 18},
				new double[]{at.y() + 12 + away, at.y() + away}), 10, 34)));
		}
		final DrawnMovie drawn = DrawnMovie.draw(chains, foreign, GAUSSIAN, NOISE, 22);
		assertFollows(drawn,
			resolve(drawn, Settings.DEFAULT.edit().filaments(FilamentChoice.ONE).build()),
			Set.of());
	}

	@Test
	void aFrameWithoutTheFilamentIsLostAndTheOthersAreNot() {
		final List<Chain> chains = DrawnMovie.waves(20, LENGTH, KNOTTED);
		chains.set(8, null);
		chains.set(9, null);
		final DrawnMovie drawn = DrawnMovie.draw(chains, List.of(), GAUSSIAN, NOISE, 23);
		final Tracks result = resolve(drawn, Settings.DEFAULT);
		assertEquals(FrameStatus.LOST, result.only().frames().get(8).status());
		assertEquals(FrameStatus.LOST, result.only().frames().get(9).status());
		assertFollows(drawn, result, Set.of(9, 10));
	}

	@Test
	void framesAreLeftOutAsAskedButHaveARow() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(12, LENGTH, 0.8), List.of(),
			GAUSSIAN, NOISE, 24);
		final Tracks result = resolve(drawn, with(new TreeSet<>(Set.of(1, 2, 3, 4, 5, 6, 7, 8)),
			new TreeSet<>(Set.of(3)), Map.of()));
		assertEquals(12, result.only().frames().size());
		assertEquals(7, result.resolved());
		assertEquals(FrameStatus.IGNORED, result.only().frames().get(2).status());
		assertEquals(FrameStatus.IGNORED, result.only().frames().get(11).status());
	}

	@Test
	void aCorrectionIsKeptAndSaid() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(12, LENGTH, 0.8), List.of(),
			GAUSSIAN, NOISE, 25);
		final Polyline given = drawn.truth().get(4).divided(15);
		final Tracks result = resolve(drawn,
			with(new TreeSet<>(), new TreeSet<>(), Map.of(5, given)));
		assertEquals(FrameStatus.CORRECTED, result.only().frames().get(4).status());
		assertFollows(drawn, result, Set.of());
	}

	@Test
	void aGrowingFilamentIsFollowedIfItsLengthIsFree() {
		final List<Chain> chains = new ArrayList<>();
		for (int t = 0; t < 25; t++)
			chains.add(DrawnMovie.wave(t, 60 + t, 0.8));
		final DrawnMovie drawn = DrawnMovie.draw(chains, List.of(), GAUSSIAN, NOISE, 26);
		final Settings d = Settings.DEFAULT;
		final Tracks result = resolve(drawn,
			d.edit().lengthModel(LengthModel.FREE).threads(2).build());
		for (int t = 0; t < 25; t++)
			assertEquals(60 + t, result.only().frames().get(t).contour().orElseThrow().length(), 2,
				"length in frame " + (t + 1));
	}

	@Test
	void publishedAndSkeletonVariantsFollowASimpleFilament() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(12, LENGTH, 0.8), List.of(),
			GAUSSIAN, NOISE, 27);
		for (final boolean refine : new boolean[]{false, true})
			for (final ResolverMethod resolver : ResolverMethod.values())
				for (final CandidateMethod candidates : CandidateMethod.values()) {
					final Settings d = Settings.DEFAULT;
					final Tracks result = resolve(drawn, d.edit().candidates(candidates)
						.resolver(resolver).refine(refine).threads(2).build());
					assertFollows(drawn, result, Set.of());
				}
	}

	@Test
	void onlyTheRegionIsSearchedAndContoursStayInTheWholeMovie() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(6, LENGTH, 0.8), List.of(),
			GAUSSIAN, NOISE, 34);
		final Movie movie = drawn.movie();
		final Region region = new Region(3, 2, movie.width() - 5, movie.height() - 4);
		final Tracks result = resolve(drawn,
			Settings.DEFAULT.edit().region(Optional.of(region)).threads(2).build());
		assertFollows(drawn, result, Set.of());
		assertEquals(movie, result.movie());
		assertEquals(0, result.only().fixedEnd().orElseThrow().distanceTo(new Point(22.4, 55.3)),
			1);
		assertEquals("Only the region x=3 y=2 width=" + region.width() + " height="
			+ region.height() + " was searched.", result.notes().get(result.notes().size() - 1));
	}

	@Test
	void aMovieWithoutAnythingSaysSo() {
		final Movie empty = new Movie("nothing", ArrayImgs.floats(50, 40, 6), Calibration.NONE);
		final String message = assertThrows(UserException.class,
			() -> new Session(empty, Settings.DEFAULT).solve(List.of(), Progress.NONE))
			.getMessage();
		assertTrue(message.startsWith("No filament was found in 'nothing'"), message);
	}

	@Test
	void whatDoesNotFitTheMovieIsNamed() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(3, LENGTH, 0.8), List.of(),
			GAUSSIAN, NOISE, 28);
		final Settings d = Settings.DEFAULT;
		final Settings outside = d.edit().fixedEnd(Optional.of(new Point(500, 3))).threads(1)
			.build();
		assertMessage(drawn, outside, "500.0,3.0");
		assertMessage(drawn, with(new TreeSet<>(Set.of(4)), new TreeSet<>(), Map.of()), "frame 4");
		assertMessage(drawn, with(new TreeSet<>(Set.of(1)), new TreeSet<>(Set.of(1)), Map.of()),
			"No frame is left");
	}

	@Test
	void correctionsThatCannotBeUsedAreNamed() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(3, LENGTH, 0.8), List.of(),
			GAUSSIAN, NOISE, 30);
		final String message = assertThrows(UserException.class,
			() -> Constraint.contour(2, Polyline.of(new double[]{5}, new double[]{6})))
			.getMessage();
		assertTrue(message.contains("correction of frame 2 needs at least two points"), message);
		assertMessage(drawn, with(new TreeSet<>(), new TreeSet<>(),
			Map.of(2, Polyline.of(new double[]{5, 500}, new double[]{6, 600}))), "500.0,600.0");
	}

	@Test
	void aCorrectionThroughTheDarkIsKeptAsGiven() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(8, LENGTH, 0.8), List.of(),
			GAUSSIAN, NOISE, 31);
		final Polyline given = Polyline.of(new double[]{22.4, 5}, new double[]{55.3, 105});
		final Tracks result = resolve(drawn,
			with(new TreeSet<>(), new TreeSet<>(), Map.of(3, given)));
		assertEquals(FrameStatus.CORRECTED, result.only().frames().get(2).status());
		assertEquals("Given by the user.", result.only().frames().get(2).reason());
	}

	@Test
	void aToldEndOrLengthThatCannotBeIsRefused() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(4, LENGTH, 0.8), List.of(),
			GAUSSIAN, NOISE, 32);
		final Settings d = Settings.DEFAULT;
		assertMessage(drawn, d.edit().fixedEnd(Optional.of(new Point(5, 104))).threads(1).build(),
			"px from any object");
		assertMessage(drawn, d.edit().length(OptionalDouble.of(15000)).threads(1).build(),
			"far too long");
	}

	@Test
	void aWrongLengthCostsConfidence() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(8, LENGTH, 0.8), List.of(),
			GAUSSIAN, NOISE, 33);
		final Settings d = Settings.DEFAULT;
		final Tracks result = resolve(drawn,
			d.edit().length(OptionalDouble.of(LENGTH / 3)).threads(2).build());
		result.only().frames()
			.forEach(f -> assertTrue(f.contour().isEmpty() || f.confidence() < 0.5,
				"frame " + f.frame() + " is sure of it: " + f.confidence()));
	}

	@Test
	void cancelsInTheMiddle() {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(6, LENGTH, KNOTTED), List.of(),
			GAUSSIAN, NOISE, 29);
		assertThrows(CancelledException.class, () -> new Session(drawn.movie(), Settings.DEFAULT)
			.solve(List.of(), new CancelledProgress(40)));
	}

	private static void assertMessage(final DrawnMovie drawn, final Settings parameters,
		final String part) {
		final String message = assertThrows(UserException.class, () -> resolve(drawn, parameters))
			.getMessage();
		assertTrue(message.contains(part), message);
	}

	private static Settings with(final SortedSet<Integer> frames, final SortedSet<Integer> ignored,
		final Map<Integer, Polyline> corrections) {
		final Settings d = Settings.DEFAULT;
		return d.edit().frames(frames).ignoreFrames(ignored).corrections(corrections).threads(2)
			.build();
	}

	private static Tracks resolve(final DrawnMovie drawn, final Settings parameters) {
		return new Session(drawn.movie(), parameters).solve(List.of(), Progress.NONE);
	}

	private static void assertFollows(final DrawnMovie drawn, final Tracks result,
		final Set<Integer> without) {
		for (int t = 0; t < drawn.truth().size(); t++) {
			if (without.contains(t + 1))
				continue;
			final Observation seen = result.filaments().get(0).frames().get(t);
			final Polyline contour = seen.contour()
				.orElseThrow(
					() -> new AssertionError("frame " + seen.frame() + ": " + seen.reason()))
				.resampled(1);
			final double distance = DiscreteFrechet.distance(contour,
				drawn.truth().get(t).resampled(1));
			assertTrue(distance < 5,
				"frame " + (t + 1) + " is off by " + distance + " px with " + result.settings());
		}
	}
}
