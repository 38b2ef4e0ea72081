package io.github.knotresolver.ui.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Alternative;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/** What a review shows and remembers, with a solver that answers by rote. */
@Timeout(30)
class ReviewModelTest {

	/** Of frames 1 to 6; NaN: lost. */
	private static final double[] CONFIDENCES = {0.99, 0.4, 0.95, 0.7, Double.NaN, 0.4};
	private static final Movie MOVIE = new Movie("drawn",
		ArrayImgs.floats(40, 40, CONFIDENCES.length), Calibration.NONE);
	private static final Polyline SHOWN = line(3), OTHER = line(7);

	private static Polyline line(final double y) {
		return Polyline.of(List.of(new Point(1, y), new Point(30, y)));
	}

	/** Whole contours are followed to the letter, and no other word has a consequence. */
	private static Tracks answer(final List<Constraint> said) {
		final List<Observation> frames = new ArrayList<>();
		for (int t = 1; t <= CONFIDENCES.length; t++) {
			final int frame = t;
			final Optional<Constraint> given = said.stream()
				.filter(c -> c.frame() == frame && c.kind() == Kind.CONTOUR).findFirst();
			if (given.isPresent())
				frames.add(new Observation(t, FrameStatus.CORRECTED, "As the user said.",
					given.map(Constraint::shape), 0, 1, 0, 1));
			else if (Double.isNaN(CONFIDENCES[t - 1]))
				frames.add(Observation.without(t, FrameStatus.LOST, "Nothing was seen."));
			else
				frames.add(new Observation(t, FrameStatus.RESOLVED, "", Optional.of(SHOWN), 0, 2, 1,
					CONFIDENCES[t - 1]).withAlternatives(List.of(new Alternative(OTHER, 2))));
		}
		return new Tracks(MOVIE, Settings.DEFAULT.edit().constraints(said).build(),
			List.of(new FilamentTrack(1, Anchor.CLAMPED, Optional.empty(), 29, 0.1, frames)),
			List.of());
	}

	private static ReviewModel model() throws InterruptedException {
		return model((said, progress) -> answer(said));
	}

	private static ReviewModel model(final Solver solver) throws InterruptedException {
		final ReviewModel model = new ReviewModel(MOVIE, solver, List.of());
		model.atRest();
		return model;
	}

	@Test
	void theLeastCertainFrameComesFirst() throws InterruptedException {
		try (ReviewModel model = model()) {
			assertEquals(List.of(5, 2, 6, 4), model.doubtful());
			final List<Integer> visited = new ArrayList<>();
			for (int i = 0; i < 5; i++) {
				model.nextDoubtful();
				visited.add(model.frame());
			}
			assertEquals(List.of(5, 2, 6, 4, 5), visited);
			model.previousDoubtful();
			assertEquals(4, model.frame());
			model.goTo(3);
			model.previousDoubtful();
			assertEquals(4, model.frame());
			model.goTo(99);
			assertEquals(6, model.frame());
			model.goTo(-1);
			assertEquals(1, model.frame());
		}
	}

	@Test
	void whatIsAcceptedOrCorrectedIsDoubtfulNoMore() throws InterruptedException {
		try (ReviewModel model = model()) {
			model.goTo(2);
			model.accept();
			assertTrue(model.isChecked(2));
			model.goTo(6);
			model.take(0);
			assertEquals(Optional.of(OTHER), model.atRest().only().frames().get(5).contour());
			assertEquals(List.of(5, 4), model.doubtful());
			assertEquals(new TreeSet<>(List.of(6)), model.changed());
			model.undo();
			model.undo();
			model.atRest();
			assertEquals(List.of(5, 2, 6, 4), model.doubtful());
			assertFalse(model.isChecked(2));
			assertFalse(model.canUndo());
			model.redo();
			model.redo();
			assertEquals(Optional.of(OTHER), model.atRest().only().frames().get(5).contour());
			assertFalse(model.canRedo());
		}
	}

	@Test
	void whatWasAcceptedIsSaidAndHoldsWhileTheContourStays() throws InterruptedException {
		final AtomicInteger solves = new AtomicInteger();
		final List<Constraint> said;
		try (ReviewModel model = model((words, progress) -> {
			solves.incrementAndGet();
			return answer(words);
		})) {
			model.goTo(2);
			model.accept();
			model.goTo(5);
			model.accept();
			model.accept();
			said = model.said();
			assertEquals(List.of(Kind.CHECKED, Kind.CHECKED),
				said.stream().map(Constraint::kind).toList());
			assertEquals(said, model.atRest().settings().constraints());
			assertEquals(1, solves.get());
			assertTrue(model.isChecked(5));
			model.undo();
			assertFalse(model.isChecked(5));
			assertEquals(said.subList(0, 1), model.atRest().settings().constraints());
		}
		try (ReviewModel tomorrow = new ReviewModel(MOVIE, (words, p) -> answer(words), said)) {
			tomorrow.atRest();
			assertEquals(List.of(6, 4), tomorrow.doubtful());
			tomorrow.goTo(2);
			tomorrow.contour(OTHER);
			tomorrow.atRest();
			assertEquals(List.of(Kind.CONTOUR, Kind.CHECKED),
				tomorrow.said().stream().map(Constraint::kind).toList());
			tomorrow.withdraw();
			tomorrow.atRest();
			assertFalse(tomorrow.isChecked(2));
		}
		final Constraint elsewhere = Constraint.checked(1, 2, OTHER);
		try (ReviewModel other = new ReviewModel(MOVIE, (words, p) -> answer(words),
			List.of(elsewhere))) {
			other.atRest();
			assertFalse(other.isChecked(2), "Another contour was found right.");
		}
	}

	/** Two free filaments, at y = 3 and y = 20; an exchange is followed as the word says. */
	private static Tracks two(final List<Constraint> said) {
		final List<FilamentTrack> filaments = new ArrayList<>();
		for (int id = 1; id <= 2; id++) {
			final List<Observation> frames = new ArrayList<>();
			for (int t = 1; t <= CONFIDENCES.length; t++) {
				final int frame = t, number = id;
				final boolean swapped = said.stream()
					.filter(c -> c.kind() == Kind.SWAP && c.frame() <= frame).count() % 2 == 1;
				final Optional<Polyline> given = said.stream().filter(
					c -> c.frame() == frame && c.filament() == number && c.kind() == Kind.CONTOUR)
					.map(Constraint::shape).findFirst();
				frames.add(new Observation(t,
					given.isPresent() ? FrameStatus.CORRECTED : FrameStatus.RESOLVED, "",
					Optional.of(given.orElse(line(id == 1 == swapped ? 20 : 3))), 0, 1, 0, 0.8));
			}
			filaments
				.add(new FilamentTrack(id, Anchor.FREE, Optional.empty(), 29, Double.NaN, frames));
		}
		return new Tracks(MOVIE, Settings.DEFAULT.edit().constraints(said).build(), filaments,
			List.of());
	}

	private static double row(final ReviewModel model, final int filament, final int frame)
		throws InterruptedException {
		return model.atRest().filaments().get(filament - 1).frames().get(frame - 1).contour()
			.orElseThrow().first().y();
	}

	@Test
	void whatWasSaidOfAContourGoesWithItWhenFilamentsAreExchanged() throws InterruptedException {
		try (ReviewModel model = model((said, progress) -> two(said))) {
			model.goTo(5);
			model.contour(line(5));
			model.atRest();
			model.goTo(6);
			model.accept();
			model.goTo(3);
			model.exchange(2);
			for (int round = 0; round < 2; round++) {
				assertEquals(3, row(model, 1, 2));
				assertEquals(20, row(model, 1, 3));
				assertEquals(3, row(model, 2, 3));
				assertEquals(5, row(model, 2, 5), "The contour that was drawn stays what it was.");
				model.choose(2);
				assertTrue(model.isChecked(6));
				model.choose(1);
				assertFalse(model.isChecked(6));
				model.undo();
				assertEquals(3, row(model, 1, 3));
				assertEquals(5, row(model, 1, 5));
				assertTrue(model.isChecked(6));
				model.redo();
			}
			model.atRest();
			model.exchange(2);
			assertEquals(List.of(Kind.CONTOUR, Kind.CHECKED),
				model.said().stream().map(Constraint::kind).toList());
			assertEquals(5, row(model, 1, 5));
			model.exchange(9);
			model.exchange(1);
			assertEquals(2, model.said().size());
		}
	}

	@Test
	void wherePlacesMeanNothingToTheSolverTheContourIsBentToThem() throws InterruptedException {
		try (ReviewModel model = model((said, progress) -> two(said))) {
			model.through(new Point(15, 6));
			assertEquals(Kind.CONTOUR, model.said().get(0).kind());
			assertEquals(0, model.said().get(0).shape().distanceTo(new Point(15, 6)), 0.7);
			model.atRest();
			model.goTo(2);
			model.tip(new Point(33, 5));
			assertEquals(0, model.said().get(1).shape().last().distanceTo(new Point(33, 5)), 0.1);
		}
	}

	@Test
	void contoursThatWereChangedElsewhereAreTakenOverInOneStep() throws InterruptedException {
		try (ReviewModel model = model((said, progress) -> two(said))) {
			final List<Constraint> shown = List.of(
				new Constraint(1, 2, Kind.CONTOUR,
					Polyline.of(List.of(new Point(1.004, 3), new Point(30, 3)))),
				new Constraint(1, 3, Kind.CONTOUR, line(4)),
				new Constraint(2, 5, Kind.CONTOUR, line(19)),
				new Constraint(9, 5, Kind.CONTOUR, line(19)));
			assertEquals(2, model.takeOver(shown));
			assertEquals(4, row(model, 1, 3));
			assertEquals(19, row(model, 2, 5));
			assertEquals(shown.subList(1, 3), model.said());
			assertEquals(0, model.takeOver(shown));
			model.undo();
			assertEquals(List.of(), model.said());
		}
	}

	@Test
	void aLiveResultIsNotSolvedAgainAndAReadOneIsSeenMeanwhile() throws Exception {
		final CountDownLatch asked = new CountDownLatch(1), go = new CountDownLatch(1);
		try (ReviewModel live = ReviewModel.live(answer(List.of()), (said, p) -> {
			throw new IllegalStateException("Nobody asked.");
		})) {
			assertTrue(live.isReady());
			live.goTo(2);
			live.accept();
			assertTrue(live.isChecked(2));
		}
		final Solver slow = (said, progress) -> {
			asked.countDown();
			try {
				go.await();
			} catch (final InterruptedException e) {
				throw new CancelledException();
			}
			return answer(said);
		};
		try (ReviewModel read = ReviewModel.finished(answer(List.of()), slow)) {
			assertTrue(asked.await(20, TimeUnit.SECONDS));
			assertFalse(read.isReady());
			assertEquals(List.of(5, 2, 6, 4), read.doubtful());
			read.refuse();
			assertEquals(List.of(), read.said());
			go.countDown();
			read.atRest();
			assertTrue(read.isReady());
			assertEquals(new TreeSet<>(), read.changed());
		}
	}

	@Test
	void aNewWordEndsWhatCouldBeDoneAgain() throws InterruptedException {
		try (ReviewModel model = model()) {
			model.tip(new Point(5, 5));
			model.undo();
			assertTrue(model.canRedo());
			model.tip(new Point(6, 6));
			assertFalse(model.canRedo());
			assertEquals(List.of(said(Kind.TIP, new Point(6, 6))), model.said());
		}
	}

	private static Constraint said(final Kind kind, final Point... places) {
		return new Constraint(1, 1, kind, Polyline.of(List.of(places)));
	}

	@Test
	void wordsThatCannotBothBeTrueOverruleEachOther() throws InterruptedException {
		final Point a = new Point(5, 5), b = new Point(9.00049, 9);
		try (ReviewModel model = model()) {
			model.through(a);
			model.through(b);
			model.tip(a);
			model.tip(b);
			assertEquals(
				List.of(said(Kind.THROUGH, a, new Point(9, 9)), said(Kind.TIP, new Point(9, 9))),
				model.said());
			model.contour(OTHER);
			assertEquals(List.of(new Constraint(1, 1, Kind.CONTOUR, OTHER)), model.said());
			model.atRest();
			model.refuse();
			assertEquals(List.of(new Constraint(1, 1, Kind.NOT, OTHER)), model.said());
			model.atRest();
			model.refuse();
			assertEquals(2, model.said().size());
			model.withdraw();
			assertEquals(List.of(), model.said());
		}
	}

	@Test
	void theNextWordOvertakesTheWorkOnTheLast() throws InterruptedException {
		final CountDownLatch working = new CountDownLatch(1);
		final AtomicInteger stopped = new AtomicInteger(), answered = new AtomicInteger();
		try (ReviewModel model = model((said, progress) -> {
			if (said.size() == 1) {
				working.countDown();
				untilCancelled(progress, stopped);
			}
			answered.incrementAndGet();
			return answer(said);
		})) {
			model.goTo(2);
			model.take(0);
			assertTrue(working.await(20, TimeUnit.SECONDS));
			// Nothing waits for the solver.
			assertEquals(Optional.of(SHOWN), model.shown().orElseThrow().contour());
			model.goTo(4);
			model.take(0);
			final List<Observation> frames = model.atRest().only().frames();
			assertEquals(Optional.of(OTHER), frames.get(1).contour());
			assertEquals(Optional.of(OTHER), frames.get(3).contour());
			assertEquals(new TreeSet<>(List.of(2, 4)), model.changed());
			assertEquals(1, stopped.get());
			assertEquals(2, answered.get());
		}
	}

	private static void untilCancelled(final Progress progress, final AtomicInteger stopped) {
		while (true) {
			try {
				progress.checkCancelled();
				Thread.sleep(1);
			} catch (final CancelledException e) {
				stopped.incrementAndGet();
				throw e;
			} catch (final InterruptedException e) {
				throw new IllegalStateException(e);
			}
		}
	}

	@Test
	void whatCannotBeFollowedIsTakenBackWithItsReason() throws InterruptedException {
		try (ReviewModel model = model((said, progress) -> {
			if (said.stream().anyMatch(c -> c.kind() == Kind.TIP))
				throw new UserException("Draw the whole contour.");
			return answer(said);
		})) {
			model.goTo(2);
			model.take(0);
			model.atRest();
			model.tip(new Point(3, 3));
			assertEquals(1, model.atRest().settings().constraints().size());
			assertEquals(Optional.of("Draw the whole contour."), model.problem());
			assertEquals(1, model.said().size());
			assertTrue(model.canUndo());
			// A contour of less than a pixel is refused before any work.
			model.contour(Polyline.of(List.of(new Point(1, 1), new Point(1.1, 1))));
			assertTrue(model.problem().orElseThrow().contains("more than a pixel apart"));
			model.accept();
			assertEquals(Optional.empty(), model.problem());
		}
	}

	@Test
	void whatWasSaidBeforeIsSaidAgain() throws InterruptedException {
		final List<Constraint> before = List.of(new Constraint(1, 4, Kind.CONTOUR, OTHER));
		try (ReviewModel model = new ReviewModel(MOVIE, (said, progress) -> answer(said), before)) {
			assertEquals(before, model.atRest().settings().constraints());
			assertEquals(List.of(5, 2, 6), model.doubtful());
			assertTrue(model.isChecked(4));
			assertFalse(model.canUndo());
		}
	}

	@Test
	void aMovieWithoutAResultSaysWhy() throws InterruptedException {
		try (ReviewModel model = new ReviewModel(MOVIE, (said, progress) -> {
			throw new UserException("No filament was found.");
		}, List.of())) {
			assertEquals("No filament was found.",
				assertThrows(UserException.class, model::atRest).getMessage());
			model.accept();
			model.take(0);
			assertEquals(List.of(), model.said());
			assertEquals(List.of(), model.doubtful());
			assertTrue(Double.isNaN(model.confidences()[3]));
		}
	}

	/** The solver's thread may still be telling of the answer before, so each thread is counted alone. */
	@Test
	void listenersHearOfFramesWordsAndAnswers() throws InterruptedException {
		final Thread caller = Thread.currentThread();
		final AtomicInteger heard = new AtomicInteger();
		final CountDownLatch answered = new CountDownLatch(1);
		try (ReviewModel model = model()) {
			model.listen(() -> {
				if (Thread.currentThread() == caller)
					heard.incrementAndGet();
				else if (model.stage().isEmpty()
					&& model.said().stream().anyMatch(c -> c.kind() == Kind.CONTOUR))
					answered.countDown();
			});
			model.goTo(2);
			assertEquals(1, heard.get());
			model.goTo(2);
			model.choose(2);
			assertEquals(1, heard.get());
			model.accept();
			assertEquals(2, heard.get());
			model.take(0);
			assertEquals(3, heard.get());
			model.atRest();
			assertTrue(answered.await(30, TimeUnit.SECONDS), "the answer was not told");
		}
	}

	@Test
	void closingStopsTheWork() throws InterruptedException {
		final AtomicInteger stopped = new AtomicInteger();
		final ReviewModel model = new ReviewModel(MOVIE, (said, progress) -> {
			untilCancelled(progress, stopped);
			return answer(said);
		}, List.of());
		model.close();
		assertThrows(UserException.class, model::atRest);
		model.undo();
		assertEquals(Optional.empty(), model.stage());
	}
}
