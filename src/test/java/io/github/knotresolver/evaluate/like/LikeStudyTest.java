package io.github.knotresolver.evaluate.like;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import net.imglib2.Cursor;
import net.imglib2.img.Img;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;
import net.imglib2.view.Views;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.CancelledProgress;
import io.github.knotresolver.evaluate.like.LikeResult.LikeMotion;
import io.github.knotresolver.evaluate.like.LikeResult.LikeMovie;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.BitDepth;
import io.github.knotresolver.simulate.Canvas;
import io.github.knotresolver.simulate.FilamentProperties.Clamp;
import io.github.knotresolver.simulate.FilamentSimulator;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;
import io.github.knotresolver.simulate.OpticalRenderer;
import io.github.knotresolver.simulate.Optics;
import io.github.knotresolver.simulate.SimulatedMovie;
import io.github.knotresolver.simulate.SimulationParameters;

/** A simulated movie stands for the user's; the study must find back how it was made. */
class LikeStudyTest {

	/** Length in µm, motors per µm², photons and width of the user's movie. */
	private static final double LENGTH = 5, DENSITY = 50, SIGNAL = 120, SIGMA = 1.6;

	private static final Optics OPTICS = new Optics(SIGMA, SIGNAL, 40, 2, Double.POSITIVE_INFINITY,
		0, 0, 2);

	/** What is simulated where the search is not looked at. */
	private static final LikeMotion MOTION = new LikeMotion(LENGTH, Clamp.PIVOT, DENSITY, 5, 20);

	private static SimulatedMovie user;

	/** The longest part, done once: with two threads. */
	private static LikeResult result;

	@BeforeAll
	static void searchOnce() {
		user = user();
		result = study(user, 2).run(4, 1, Progress.NONE);
	}

	private static LikeStudy study(final SimulatedMovie movie, final int threads) {
		return new LikeStudy(source(movie, threads), (m, p, progress) -> stub(m, p), Progress.NONE);
	}

	/** Every other second frame of a coil, so that its own frame interval is 5 s. */
	private static SimulatedMovie user() {
		final SimulationParameters like = SimulationParameters.published(LENGTH, DENSITY, 77);
		final Trajectory all = new FilamentSimulator(like).run(Progress.NONE);
		final List<Polyline> some = new ArrayList<>();
		for (int t = 24; t < 84; t += 2)
			some.add(all.curves().get(t));
		final Trajectory trajectory = new Trajectory(some, 2 * all.frameInterval());
		return SimulatedMovie.render("user.tif", trajectory, Canvas.around(trajectory, 0.1, 20),
			new OpticalRenderer(OPTICS, 9), BitDepth.SIXTEEN, Progress.NONE);
	}

	private static LikeSource source(final SimulatedMovie movie, final int threads) {
		final Settings d = Settings.DEFAULT;
		return new LikeSource(movie.movie(), movie.truth().stream().map(Optional::of).toList(),
			d.edit().threads(threads).build());
	}

	/** A resolver that finds the filament in even frames, but beside it in every fourth. */
	private static Tracks stub(final Movie movie, final Settings parameters) {
		final List<Observation> frames = new ArrayList<>();
		for (int frame = 1; frame <= movie.size(); frame++)
			frames.add(frame % 2 == 1
				? Observation.without(frame, FrameStatus.LOST, "Not looked for.")
				: new Observation(frame, FrameStatus.RESOLVED, "",
					Optional.of(Polyline.of(new double[]{0, 50}, new double[]{0, 0})), 0, 1, 0,
					frame % 4 == 0 ? 0.2 : 0.4));
		return new Tracks(movie, parameters,
			List.of(new FilamentTrack(1, Anchor.CLAMPED, Optional.empty(), 50, 1, frames)),
			List.of());
	}

	@Test
	void aMovieLikeASimulatedOneIsMadeAsThatWas() {
		assertAll(() -> assertAlike(result, "frames", 0), //
			() -> assertAlike(result, "frame interval [s]", 0), //
			() -> assertAlike(result, "pixel size [µm]", 0), //
			() -> assertAlike(result, "length [µm]", 0.002), //
			() -> assertAlike(result, "line width [px]", 0.08), //
			() -> assertAlike(result, "background [grey]", 0.02), //
			() -> assertAlike(result, "peak over background [grey]", 0.08), //
			() -> assertAlike(result, "noise [grey]", 0.08), //
			() -> assertAlike(result, "noise on the line [grey]", 0.2), //
			() -> assertAlike(result, "step of the tip [px]", 0.25), //
			() -> assertAlike(result, "step of the contour [px]", 0.25), //
			() -> assertAlike(result, "turning along it [turns]", 0.25),
			() -> assertEquals(1, result.motion().interval() / 5, 0.35, "time scale"));
	}

	private static void assertAlike(final LikeResult result, final String quantity,
		final double tolerance) {
		final double yours = result.traits().values().get(quantity);
		assertEquals(yours, result.simulated(quantity), tolerance * yours + 1e-9, quantity);
	}

	@Test
	void greyValuesThatAreRealNumbersComeBackToo() {
		final Img<FloatType> real = ArrayImgs.floats(user.movie().width(), user.movie().height(),
			user.movie().size());
		final Cursor<? extends RealType<?>> grey = Views.flatIterable(user.movie().frames())
			.cursor();
		for (final FloatType value : real)
			value.setReal(0.001 * grey.next().getRealDouble());
		final SimulatedMovie same = new SimulatedMovie(
			new Movie("real.tif", real, user.movie().calibration()), user.truth());
		final LikeResult again = study(same, 2).run(MOTION, 1, 1, Progress.NONE);
		assertTrue(again.traits().values().get("peak over background [grey]") < 1);
		assertAlike(again, "background [grey]", 0.02);
		assertAlike(again, "peak over background [grey]", 0.08);
		assertAlike(again, "noise [grey]", 0.08);
	}

	@Test
	void resultsDoNotDependOnThreadsButOnTheSeed() {
		final LikeStudy study = study(user, 1);
		final LikeResult other = study.run(4, 1, Progress.NONE);
		assertEquals(result.motion(), other.motion());
		assertEquals(result.movies().stream().map(LikeMovie::traits).toList(),
			other.movies().stream().map(LikeMovie::traits).toList());
		assertEquals(study.movie(MOTION, 3, Progress.NONE).truth(),
			study.movie(MOTION, 3, Progress.NONE).truth());
		assertNotEquals(study.movie(MOTION, 3, Progress.NONE).truth(),
			study.movie(MOTION, 4, Progress.NONE).truth());
	}

	@Test
	void aMovieInWhichNothingIsFoundCountsAsNotResolved() {
		final LikeStudy study = new LikeStudy(source(user, 2), (m, p, progress) -> {
			throw new UserException("No filament was found.");
		}, Progress.NONE);
		final LikeResult none = study.run(MOTION, 1, 1, Progress.NONE);
		assertEquals(0, none.resolved().percent());
		assertEquals(0, none.positionErrors().length);
		assertTrue(Double.isNaN(none.discrimination()));
		assertEquals(Optional.of("No filament was found."), none.movies().get(0).refusal());
	}

	@ParameterizedTest
	@CsvSource({"2.5, s, 2", "2500, ms, 2", "0.5, min, 0.16666666666666666"})
	void timeRunsAsTheMoviesOwnUnitSays(final double interval, final String unit,
		final double speed) {
		assertEquals(speed, like(interval, unit).speed().orElseThrow(), 1e-12);
	}

	@Test
	void withoutFrameIntervalNobodyKnowsHowTimeRuns() {
		assertTrue(like(1, Calibration.NONE.timeUnit()).speed().isEmpty());
	}

	/** Nothing but the frame interval counts. */
	private static LikeResult like(final double interval, final String unit) {
		final Movie movie = new Movie("m", user.movie().frames(),
			new Calibration(0.1, "µm", interval, unit));
		return new LikeResult(source(new SimulatedMovie(movie, user.truth()), 1), MOTION,
			result.traits(), List.of(), 1);
	}

	@Test
	void aUserMayStop() {
		final LikeStudy study = study(user, 2);
		assertThrows(CancelledException.class, () -> study.run(1, 1, new CancelledProgress()));
	}

	@Test
	void whatTellsTooLittleIsRefused() {
		final List<Optional<Polyline>> few = new ArrayList<>();
		for (int t = 0; t < user.movie().size(); t++)
			few.add(t < 2 ? Optional.of(user.truth().get(t)) : Optional.empty());
		assertRefused("like has contours in fewer than 3 neighbouring frames", user.movie(), few);
		assertRefused("movie 'user.tif' has 30 frames, but the result has 29", user.movie(),
			few.subList(1, few.size()));
		assertRefused("like is a result in the unit 'pixel'",
			new Movie("m", user.movie().frames(), Calibration.NONE),
			user.truth().stream().map(Optional::of).toList());
		assertEquals("movies must be a whole number from 1 to 1000, but is 0.",
			assertThrows(UserException.class, () -> LikeStudy.check(0)).getMessage());
	}

	private static void assertRefused(final String start, final Movie movie,
		final List<Optional<Polyline>> contours) {
		final String message = assertThrows(UserException.class,
			() -> new LikeSource(movie, contours, Settings.DEFAULT)).getMessage();
		assertTrue(message.startsWith(start), message);
	}
}
