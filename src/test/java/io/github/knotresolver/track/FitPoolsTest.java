package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.OpenFrames.Seen;

/** Whether a fixed end moves, where hardly any frame shows it. */
class FitPoolsTest {

	private static final double NOISE = 0.7;

	private static FitPools with(final double... energies) {
		final FilamentEstimate estimate = new FilamentEstimate(
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.5, 1), 1, 50, 0.1, new Point(0, 0), false);
		return new FitPools(List.of(), List.of(),
			new FilamentCourse(estimate, AnchorPath.still(new Point(0, 0), energies.length),
				LengthCourse.constant(50, energies.length), NOISE, 1),
			List.of(), Arrays.stream(energies).mapToObj(e -> List.of(fit(e), fit(e + 3))).toList(),
			FitSettings.DEFAULT);
	}

	private static Fit fit(final double energy) {
		return new Fit(Chain.along(Drawn.line(0, 9, 50, 9), 10, 50), 0, energy, 1);
	}

	@Test
	void theCheapestFitOfEachFrameCounts() {
		assertEquals(-30, with(-10, -20, 5).price(), 1e-9);
	}

	@Test
	void anEndStaysUnlessMovingExplainsMoreThanNoise() {
		final FitPools moving = with(-10, -20), alike = with(-9.5, -20), worse = with(-10, -17);
		assertSame(alike, moving.orStill(alike));
		assertSame(moving, moving.orStill(worse));
	}

	private static OpenFrames open(final int frames) {
		return new OpenFrames(IntStream.range(0, frames)
			.mapToObj(t -> new Seen(t, fit(0).chain(), true, true, false)).toList());
	}

	@Test
	void skeletonsAloneSayThatAnEndMovesIfHardlyAnyFrameIsOpen() {
		final AnchorPath moving = new AnchorPath(
			IntStream.range(0, 20).mapToObj(t -> new Point(t, 0)).toList(), new double[20]);
		assertTrue(moving.isDoubtful(open(2)));
		assertFalse(moving.isDoubtful(open(12)));
		assertTrue(AnchorPath.still(new Point(3, 3), 20).isDoubtful(open(2)));
		assertFalse(AnchorPath.still(new Point(3, 3), 20).isDoubtful(open(12)));
	}

	private static final double LENGTH = 80;

	private static final LineModel LINE = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.5, 1);
	private static final List<Chain> TRUTH = DrawnMovie.waves(9, LENGTH, 1.2);

	/** A course so many times as long as the filament. */
	private static FilamentCourse course(final double times) {
		return new FilamentCourse(
			new FilamentEstimate(LINE, 1, times * LENGTH, Double.NaN, TRUTH.get(0).start(), false),
			AnchorPath.still(TRUTH.get(0).start(), TRUTH.size()),
			LengthCourse.constant(times * LENGTH, TRUTH.size()), NOISE, 1);
	}

	/** A movie in which the filament was found so many times as long as it is. */
	private static FitPools found(final double times) {
		return found(times, course(times));
	}

	private static FitPools found(final double times, final FilamentCourse known) {
		final DrawnMovie drawn = DrawnMovie.draw(TRUTH, List.of(), LINE, 0.05, 4);
		return new FitPools(List.of(),
			IntStream.range(0, TRUTH.size()).mapToObj(drawn::frame).toList(), known, List.of(),
			TRUTH.stream().map(c -> List.of(new Fit(c.resized(times * LENGTH), 0, 0, 1))).toList(),
			FitSettings.DEFAULT);
	}

	/** What all frames say of it. */
	private static Optional<FilamentCourse> ofAll(final double times) {
		return ofAll(found(times), times);
	}

	private static Optional<FilamentCourse> ofAll(final FitPools found, final double times) {
		return found.lengthOfAll(IntStream.range(0, TRUTH.size())
			.mapToObj(t -> new Observation(t + 1, FrameStatus.RESOLVED, "",
				Optional.of(TRUTH.get(t).resized(times * LENGTH).contour()), 0, 1, 0, 1))
			.toList(), Workers.HERE);
	}

	@ParameterizedTest
	@ValueSource(doubles = {0.95, 1, 1.04})
	void contoursAreFittedAgainAsLongAsTheFilamentIs(final double times) {
		final FitPools again = found(times).withCourse(course(1), Workers.HERE, Progress.NONE);
		for (int t = 0; t < TRUTH.size(); t++) {
			final List<Fit> fits = again.fits().get(t);
			assertEquals(1, fits.size(), "frame " + t);
			assertEquals(LENGTH, fits.get(0).chain().length(), 1e-9);
			final double off = fits.get(0).chain().divided(40).farthest(TRUTH.get(t).divided(40));
			assertTrue(off < 0.5, "frame " + t + " is off by " + off + " px");
			assertTrue(fits.get(0).energy() < -30, "frame " + t + ": " + fits.get(0).energy());
		}
	}

	@ParameterizedTest
	@ValueSource(doubles = {0.96, 1.03})
	void allFramesTogetherSayHowLongAFilamentIs(final double times) {
		final FilamentCourse course = ofAll(times).orElseThrow();
		final FilamentEstimate settled = course.estimate();
		assertEquals(LENGTH, settled.length(), 0.004 * LENGTH);
		assertEquals(settled.length(), course.length().of(4));
		assertTrue(settled.lengthError() < 0.003 * LENGTH, "error " + settled.lengthError());
	}

	@Test
	void aLengthThatIsRightStays() {
		assertEquals(Optional.empty(), ofAll(1));
	}

	/** A movie whose fixed end is taken for so many pixels farther on along the filament. */
	private static Optional<FilamentCourse> ofAllIfClampedAt(final double along) {
		final FilamentCourse right = course(1);
		final List<Point> places = TRUTH.stream()
			.map(c -> new Point(c.start().x() + along * Math.cos(c.angle(0)),
				c.start().y() + along * Math.sin(c.angle(0))))
			.toList();
		final double[] weights = new double[TRUTH.size()];
		Arrays.fill(weights, FitSettings.DEFAULT.clampWeight());
		return ofAll(found(1, right.withAnchor(new AnchorPath(places, weights))), 1);
	}

	/** Held there, all contours would be too short. */
	@Test
	void lightBeforeTheClampIsTheFilament() {
		assertEquals(Optional.empty(), ofAllIfClampedAt(1));
	}

	/** Where it ends depends on how bright it is there, which was learned with the length. */
	@Test
	void ofALineWithADimEndTheLengthAloneIsNotChanged() {
		final FilamentCourse even = course(0.96);
		final FilamentCourse dim = even
			.withEstimate(new FilamentEstimate(LINE.withBrightness(new double[]{1.4, 0.6}), 1,
				0.96 * LENGTH, Double.NaN, even.estimate().fixedEnd(), false));
		assertTrue(ofAll(found(0.96, even), 0.96).isPresent());
		assertEquals(Optional.empty(), ofAll(found(0.96, dim), 0.96));
	}

	/** A clamp that stays is where the light begins if that is before it: no tip is pushed out. */
	@Test
	void theClampIsFoundTogetherWithTheLength() {
		final Chain first = TRUTH.get(0);
		final Point late = new Point(first.start().x() + 3 * Math.cos(first.angle(0)),
			first.start().y() + 3 * Math.sin(first.angle(0)));
		final double times = 1 - 3 / LENGTH;
		final FilamentCourse thought = course(times)
			.withAnchor(AnchorPath.still(late, TRUTH.size()));
		final FilamentCourse course = ofAll(found(times, thought), times).orElseThrow();
		assertEquals(LENGTH, course.estimate().length(), 0.004 * LENGTH);
		assertEquals(0, course.anchor().at(3).distanceTo(first.start()), 0.3);
		assertEquals(0, course.anchor().range());
	}

	/** Something hides it there. */
	@Test
	void theFilamentBeginsAtItsClampEvenIfItsLightDoesNot() {
		final double length = ofAllIfClampedAt(-1.5).orElseThrow().estimate().length();
		assertEquals(LENGTH + 1.5, length, 0.004 * LENGTH);
	}

	/** Frames in which the fixed end is carried along, and was thought to be elsewhere. */
	private static FitPools held(final IntFunction<Point> carried, final IntFunction<Point> off) {
		final List<Chain> truth = IntStream.range(0, TRUTH.size())
			.mapToObj(t -> TRUTH.get(t).shifted(carried.apply(t).x(), carried.apply(t).y()))
			.toList();
		final DrawnMovie drawn = DrawnMovie.draw(truth, List.of(), LINE, 0.05, 4);
		final double[] weights = new double[truth.size()];
		Arrays.fill(weights, FitSettings.DEFAULT.clampWeight());
		final AnchorPath thought = new AnchorPath(IntStream.range(0, truth.size())
			.mapToObj(t -> shifted(truth.get(t).start(), off, t)).toList(), weights);
		final FitPools begun = new FitPools(List.of(),
			IntStream.range(0, truth.size()).mapToObj(drawn::frame).toList(),
			course(1).withAnchor(thought),
			truth.stream().map(c -> new CandidateSet(List.of(), false)).toList(),
			truth.stream().map(c -> List.of(new Fit(c, 0, 0, 1))).toList(), FitSettings.DEFAULT);
		return begun.withCourse(begun.course(), Workers.HERE, Progress.NONE);
	}

	private static Point shifted(final Point at, final IntFunction<Point> by, final int t) {
		return new Point(at.x() + by.apply(t).x(), at.y() + by.apply(t).y());
	}

	private static double off(final Point at, final int t, final IntFunction<Point> carried) {
		return at.distanceTo(shifted(TRUTH.get(t).start(), carried, t));
	}

	/** Contours that are held begin where the fixed end was thought to be, and so confirm it. */
	@Test
	void aFixedEndThatMovesIsWhereContoursBeginThatAreNotHeld() {
		final IntFunction<Point> drift = t -> new Point(0.4 * t, -0.2 * t);
		final FitPools held = held(drift, t -> new Point(1.4, -1));
		final AnchorPath settled = held.withAnchorOfAll(false, true, Workers.HERE, Progress.NONE)
			.anchor();
		for (int t = 0; t < TRUTH.size(); t++) {
			final double begins = off(held.fits().get(t).get(0).chain().start(), t, drift);
			assertTrue(begins > 1, "held, frame " + t + ": " + begins + " px");
		}
		assertFollows(settled, drift);
	}

	@Test
	void aFixedEndThatSurelyStaysIsNotAskedWhereItIs() {
		final FitPools still = jittering(1.5);
		assertSame(still.course(), still.withAnchorOfAll(false, true, Workers.HERE, Progress.NONE));
	}

	/** Frames in which the fixed end jitters by so many pixels, and was thought to stay. */
	private static FitPools jittering(final double by) {
		return thoughtStill(t -> jitter(t, by));
	}

	private static FitPools thoughtStill(final IntFunction<Point> carried) {
		final Point first = TRUTH.get(0).start();
		final FitPools held = held(carried, t -> {
			final Point there = shifted(TRUTH.get(t).start(), carried, t);
			return new Point(first.x() - there.x(), first.y() - there.y());
		});
		return new FitPools(held.frames(), held.light(), held.course().withNoise(0.05), held.sets(),
			held.fits(), held.settings());
	}

	private static Point jitter(final int t, final double by) {
		return new Point(by * (t % 3 - 1), by * (t * 7 % 5 - 2) / 2);
	}

	@Test
	void aFixedEndThatJittersIsFollowedIfItStayedByLittle() {
		final FitPools held = jittering(2);
		assertEquals(0, held.course().anchor().range());
		final AnchorPath settled = held.withAnchorOfAll(true, true, Workers.HERE, Progress.NONE)
			.anchor();
		assertFollows(settled, t -> jitter(t, 2));
	}

	private static void assertFollows(final AnchorPath settled, final IntFunction<Point> carried) {
		for (int t = 0; t < TRUTH.size(); t++) {
			final double off = off(settled.at(t), t, carried);
			assertTrue(off < 0.8, "frame " + t + ": " + off + " px");
		}
	}

	@ParameterizedTest
	@ValueSource(doubles = {0.3, 0.9})
	void oneThatDriftsIsFollowedHoweverFar(final double by) {
		final IntFunction<Point> drift = t -> new Point(by * t, -0.6 * by * t);
		final AnchorPath settled = thoughtStill(drift)
			.withAnchorOfAll(true, true, Workers.HERE, Progress.NONE).anchor();
		assertFollows(settled, drift);
	}

	@Test
	void aFewFramesDoNotTellThatItDrifts() {
		final List<Optional<FreedEnds.Freed>> drift = IntStream.range(0, 9)
			.mapToObj(t -> Optional.of(
				new FreedEnds.Freed(TRUTH.get(0).shifted(2. * t, -t), Math.hypot(2 * t, t), 1, 1)))
			.toList();
		assertTrue(new FreedEnds(drift).areElsewhere(0.01, true));
		assertFalse(new FreedEnds(drift.subList(0, 4)).areElsewhere(0.01, true));
		assertFalse(new FreedEnds(drift).areElsewhere(1, true));
		// Beside others, a glider's end goes one way, too.
		assertFalse(new FreedEnds(drift).areElsewhere(0.01, false));
	}

	/** Skeletons would have seen that; a filament beside it takes contours with it. */
	@Test
	void oneThatSeemsToGoFarAndComeBackIsNot() {
		final FitPools held = jittering(6);
		assertSame(held.course(), held.withAnchorOfAll(true, true, Workers.HERE, Progress.NONE));
	}

	@Test
	void aContourThatLightDoesNotTurnBeginsAtTheFixedEnd() {
		final DrawnMovie drawn = DrawnMovie.draw(TRUTH, List.of(), LINE, 0.05, 4);
		final Chain right = TRUTH.get(3).divided(FilamentEstimator.links(LENGTH));
		final FilamentFitter free = new FilamentFitter(drawn.frame(3), LINE,
			FilamentEstimator.links(LENGTH), Optional.empty(), FitSettings.DEFAULT);
		final Fit wrong = free.fit(right.reversed(), Optional.empty());
		final Fit turned = FreedEnds.rightWayRound(wrong, right.start(), free);
		assertTrue(turned.chain().start().distanceTo(right.start()) < 0.5);
		assertEquals(wrong.energy(), turned.energy(), 0.1);
		final Point elsewhere = new Point(right.start().x() + 5, right.start().y());
		assertSame(wrong, FreedEnds.rightWayRound(wrong, elsewhere, free));
	}

	@Test
	void oneThatStaysIsNotFollowedByChance() {
		final FitPools held = jittering(0.2);
		assertSame(held.course(), held.withAnchorOfAll(true, true, Workers.HERE, Progress.NONE));
	}

	@Test
	void anEndThatJumpedInOneFrameIsElsewhereInThatFrameOnly() {
		final IntFunction<Point> jump = t -> new Point(t == 4 ? 5 : 0, t == 4 ? 4 : 0);
		final FitPools held = held(jump, t -> new Point(t == 4 ? -5 : 0, t == 4 ? -4 : 0));
		final FitPools free = held.withJumps(Workers.HERE, Progress.NONE);
		for (int t = 0; t < TRUTH.size(); t++) {
			final double off = off(free.course().anchor().at(t), t, jump);
			assertTrue(off < 0.5, "frame " + t + ": " + off + " px");
			if (t != 4)
				assertSame(held.fits().get(t), free.fits().get(t), "frame " + t);
		}
		final Fit best = free.fits().get(4).stream().min(Comparator.comparingDouble(Fit::energy))
			.orElseThrow();
		final double apart = best.chain().divided(40)
			.farthest(TRUTH.get(4).shifted(5, 4).divided(40));
		assertTrue(apart < 0.5, apart + " px");
		// The old place remains possible, so that a doubt is not settled by where the end was.
		final double far = Math.hypot(5, 4), weight = free.course().anchor().weight(4);
		assertTrue(weight * far * far < 1, "weight " + weight);
	}

	@Test
	void whereTheFixedEndIsElsewhereInAllFramesNoneIsAJump() {
		final FitPools held = held(t -> new Point(0, 0), t -> new Point(4, 3));
		assertSame(held, held.withJumps(Workers.HERE, Progress.NONE));
		final FitPools right = held(t -> new Point(0, 0), t -> new Point(0, 0));
		assertSame(right, right.withJumps(Workers.HERE, Progress.NONE));
	}
}
