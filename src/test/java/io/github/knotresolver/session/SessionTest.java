package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.CancelledProgress;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Alternative;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.ResolverMethod;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/** A session answers as a new one would, whatever it was asked before. */
class SessionTest {

	private static final int FRAMES = 14;
	private static final Settings SETTINGS = Settings.DEFAULT.edit().threads(2).build();

	private static DrawnMovie drawn;
	private static Session session;
	private static Tracks silent;

	@BeforeAll
	static void resolve() {
		drawn = DrawnMovie.draw(DrawnMovie.waves(FRAMES, 80, 3.6), List.of(), LINE, 0.05, 41);
		session = new Session(drawn.movie(), SETTINGS);
		silent = session.solve(List.of(), Progress.NONE);
	}

	private static final LineModel LINE = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1);

	private static Observation frame(final Tracks tracks, final int frame) {
		return tracks.only().frames().get(frame - 1);
	}

	private static Polyline shifted(final Polyline contour, final double dx) {
		final double[] x = contour.xs();
		for (int i = 0; i < x.length; i++)
			x[i] += dx * i / x.length;
		return Polyline.of(x, contour.ys());
	}

	private static Constraint at(final int frame, final Kind kind, final Point place) {
		return new Constraint(1, frame, kind, Polyline.of(List.of(place)));
	}

	private static void assertSame(final Tracks expected, final Tracks actual) {
		assertEquals(expected.filaments(), actual.filaments());
		assertEquals(expected.notes(), actual.notes());
		assertEquals(expected.settings(), actual.settings());
	}

	@Test
	void orderDoesNotMatterAndAskingAgainIsAskingAnew() {
		final Constraint contour = Constraint.contour(4, shifted(drawn.truth().get(3), 9));
		final Constraint through = at(9, Kind.THROUGH, drawn.truth().get(8).point(20));
		final Constraint refused = new Constraint(1, 6, Kind.NOT,
			frame(silent, 6).contour().orElseThrow());
		session.solve(List.of(refused), Progress.NONE);
		session.solve(List.of(refused, contour), Progress.NONE);
		final Tracks again = session.solve(List.of(refused, contour, through), Progress.NONE);
		final Tracks anew = new Session(drawn.movie(), SETTINGS)
			.solve(List.of(through, refused, contour), Progress.NONE);
		assertSame(anew, again);
		assertEquals(new Session(drawn.movie(),
			SETTINGS.edit().constraints(List.of(contour, through, refused)).threads(1).build())
			.solve(List.of(), Progress.NONE).only(), again.only());
		assertSame(silent, session.solve(List.of(), Progress.NONE));
	}

	@Test
	void aPlaceThatTheContourPassesIsConfirmed() {
		final Tracks told = session
			.solve(List.of(at(5, Kind.THROUGH, drawn.truth().get(4).point(30)),
				at(8, Kind.TIP, drawn.truth().get(7).last())), Progress.NONE);
		for (final int frame : new int[]{5, 8}) {
			assertEquals(FrameStatus.CORRECTED, frame(told, frame).status());
			assertEquals("As the user said.", frame(told, frame).reason());
			assertEquals(frame(silent, frame).contour(), frame(told, frame).contour());
		}
	}

	@ParameterizedTest
	@CsvSource({"THROUGH", "TIP"})
	void aPlaceInTheDarkLeavesTheFrameUnresolvedAndTheOthersAsTheyAre(final Kind kind) {
		final Tracks told = session.solve(List.of(at(7, kind, new Point(2, 2))), Progress.NONE);
		assertEquals(FrameStatus.UNRESOLVED, frame(told, 7).status());
		assertTrue(frame(told, 7).reason().contains("draw the whole contour"));
		assertEquals(frame(silent, 3).contour(), frame(told, 3).contour());
	}

	@Test
	void aRefusedContourIsNotShownAgain() {
		final Polyline shown = frame(silent, 6).contour().orElseThrow();
		final Observation other = frame(
			session.solve(List.of(new Constraint(1, 6, Kind.NOT, shown)), Progress.NONE), 6);
		assertNotEquals(Optional.of(shown), other.contour());
		assertTrue(
			other.status() == FrameStatus.UNRESOLVED || other.reason().contains("Another contour"),
			other.toString());
	}

	@Test
	void alternativesAreOthersAndDearer() {
		int alternatives = 0;
		for (final Observation o : silent.only().frames()) {
			double last = o.cost();
			for (final Alternative a : o.alternatives()) {
				alternatives++;
				assertTrue(a.cost() >= last, "frame " + o.frame());
				assertNotEquals(o.contour(), Optional.of(a.contour()));
				last = a.cost();
			}
		}
		assertTrue(alternatives > 0);
	}

	@Test
	void constraintsOfOtherPixelsAreThoseOfTheMovie() {
		final Region region = new Region(3, 2, drawn.movie().width() - 5,
			drawn.movie().height() - 4);
		final Polyline given = drawn.truth().get(4).divided(30);
		final Tracks told = new Session(drawn.movie(),
			SETTINGS.edit().region(Optional.of(region)).build())
			.solve(List.of(Constraint.contour(5, given)), Progress.NONE);
		assertEquals(FrameStatus.CORRECTED, frame(told, 5).status());
		assertEquals(0, frame(told, 5).contour().orElseThrow().last().distanceTo(given.last()), 2);
		assertEquals(List.of(Constraint.contour(5, given)), told.settings().constraints());
	}

	@Test
	void whatCannotBeFollowedIsRefused() {
		final Constraint second = new Constraint(2, 3, Kind.CONTOUR, drawn.truth().get(2));
		assertTrue(
			assertThrows(UserException.class, () -> session.solve(List.of(second), Progress.NONE))
				.getMessage().contains("filament 2, but the movie has 1"));
		final Session skeletons = new Session(drawn.movie(),
			SETTINGS.edit().resolver(ResolverMethod.PAPER).build());
		assertTrue(assertThrows(UserException.class, () -> skeletons
			.solve(List.of(at(3, Kind.TIP, drawn.truth().get(2).last())), Progress.NONE))
			.getMessage().contains("whole contours only"));
	}

	@Test
	void aSessionThatWasStoppedCanBeAskedAgain() {
		final Session other = new Session(drawn.movie(), SETTINGS);
		assertThrows(CancelledException.class,
			() -> other.solve(List.of(), new CancelledProgress(60)));
		assertSame(silent, other.solve(List.of(), Progress.NONE));
	}
}
