package io.github.knotresolver.ui.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Drag;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.AnchorChoice;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Session;

/** A review of two filaments that glide across each other. */
class ReviewSceneTest {

	private static final Settings SETTINGS = Settings.DEFAULT.edit().anchor(AnchorChoice.FREE)
		.threads(2).build();

	@TempDir
	Path home;

	private static Chain rod(final double x, final double y, final double angle,
		final double length) {
		final List<Point> points = new ArrayList<>(List.of(new Point(x, y)));
		for (int i = 0; i < 30; i++) {
			final double course = angle + 0.15 * Math.sin(0.2 * i);
			final Point last = points.get(i);
			points.add(new Point(last.x() + length / 30 * Math.cos(course),
				last.y() + length / 30 * Math.sin(course)));
		}
		return Chain.along(Polyline.of(points), 30, length);
	}

	@Test
	void filamentsAreExchangedBentAndRefusedAndTheFileRepeatsIt() throws Exception {
		final List<Chain> one = new ArrayList<>();
		final List<List<Chain>> other = new ArrayList<>();
		for (int t = 0; t < 6; t++) {
			one.add(rod(12 + 4 * t, 70, 0.1, 48));
			other.add(List.of(rod(45, 12 + 6 * t, 1.3, 40)));
		}
		final DrawnMovie drawn = DrawnMovie.draw(one, other,
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), 0.05, 7);
		try (ReviewModel model = new ReviewModel(drawn.movie(),
			new Session(drawn.movie(), SETTINGS)::solve, List.of())) {
			final Tracks before = model.atRest();
			assertEquals(2, before.filaments().size());
			final int meeting = model.meetings().getOrDefault(2, new TreeSet<>(List.of(0))).first();
			assertTrue(meeting > 1, "They cross in " + meeting);
			model.goTo(4);
			model.exchange(2);
			final Tracks swapped = model.atRest();
			assertEquals(Optional.empty(), model.problem());
			for (int t = 1; t <= 6; t++)
				assertEquals(t < 4, same(place(before, 1, t), place(swapped, 1, t)), "frame " + t);
			model.goTo(5);
			model.refuse();
			assertEquals(FrameStatus.UNRESOLVED,
				model.atRest().filaments().get(0).frames().get(4).status());
			model.goTo(6);
			final Polyline shown = model.shown().orElseThrow().contour().orElseThrow();
			final Point beside = new Point(shown.at(20).x() + 3, shown.at(20).y() + 3);
			model.drag(Drag.at(shown, shown.at(20), 1).orElseThrow(), beside);
			final Tracks said = model.atRest();
			assertTrue(said.filaments().get(0).frames().get(5).contour().orElseThrow()
				.distanceTo(beside) < 0.7);
			final Path file = home.resolve(CorrectionsCsv.FILE);
			CorrectionsCsv.write(file, model.said());
			assertEquals(model.said(), CorrectionsCsv.read(file));
			assertEquals(said.filaments(),
				new Session(drawn.movie(),
					SETTINGS.edit().threads(1).constraints(CorrectionsCsv.read(file)).build())
					.solve(List.of(), Progress.NONE).filaments());
			assertNotEquals(before.filaments(), said.filaments());
		}
	}

	@Test
	void placesThatAFileTellsBendTheContourOfTheFilamentThatIsMeant() {
		final List<Chain> one = new ArrayList<>();
		final List<List<Chain>> other = new ArrayList<>();
		for (int t = 0; t < 4; t++) {
			one.add(rod(12 + 4 * t, 70, 0.1, 48));
			other.add(List.of(rod(45, 12 + 6 * t, 1.3, 40)));
		}
		final DrawnMovie drawn = DrawnMovie.draw(one, other,
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), 0.05, 7);
		final Session session = new Session(drawn.movie(), SETTINGS);
		final Tracks before = session.solve(List.of(), Progress.NONE);
		final Polyline shown = contour(before, 2, 2);
		final Point a = beside(shown, 12, 2.5), b = beside(shown, 18, -2),
			end = beside(shown, shown.length(), 3), far = new Point(5, 90);
		final List<Constraint> said = List.of(
			new Constraint(2, 2, Kind.THROUGH, Polyline.of(List.of(a, b))),
			new Constraint(2, 2, Kind.TIP, Polyline.of(List.of(end))),
			new Constraint(1, 3, Kind.TIP, Polyline.of(List.of(far))));
		final Tracks told = session.solve(said, Progress.NONE);
		final Polyline bent = contour(told, 2, 2);
		assertEquals(FrameStatus.CORRECTED, told.filaments().get(1).frames().get(1).status());
		assertTrue(bent.distanceTo(a) < 0.3 && bent.distanceTo(b) < 0.3, "through");
		assertTrue(bent.last().distanceTo(end) < 0.3, "tip");
		assertTrue(bent.first().distanceTo(shown.first()) < 1, "What is far stays");
		assertEquals(FrameStatus.UNRESOLVED, told.filaments().get(0).frames().get(2).status());
		assertEquals(contour(before, 1, 2), contour(told, 1, 2));
		assertEquals(contour(before, 2, 3), contour(told, 2, 3));
		final List<Constraint> mixed = List.of(said.get(2), said.get(1), said.get(0));
		assertEquals(told.filaments(),
			new Session(drawn.movie(), SETTINGS.edit().threads(1).constraints(mixed).build())
				.solve(List.of(), Progress.NONE).filaments());
		// Of one place more than a curve can be near at once, nothing is made up.
		final Polyline apart = Polyline.of(List.of(beside(shown, 20, 3), beside(shown, 20, -3),
			beside(shown, 20.5, 3.5), beside(shown, 20.5, -3.5)));
		final Tracks torn = session.solve(List.of(new Constraint(2, 2, Kind.THROUGH, apart)),
			Progress.NONE);
		final var frame = torn.filaments().get(1).frames().get(1);
		assertTrue(frame.status() == FrameStatus.UNRESOLVED && frame.contour().isEmpty(),
			frame.toString());
	}

	private static Polyline contour(final Tracks tracks, final int filament, final int frame) {
		return tracks.filaments().get(filament - 1).frames().get(frame - 1).contour().orElseThrow();
	}

	/** A place so far to the side of a contour. */
	private static Point beside(final Polyline contour, final double arc, final double away) {
		final Point from = contour.at(Math.max(0, arc - 1)), to = contour.at(Math.max(1, arc));
		final double length = from.distanceTo(to);
		return new Point(to.x() - away * (to.y() - from.y()) / length,
			to.y() + away * (to.x() - from.x()) / length);
	}

	private static Point place(final Tracks tracks, final int filament, final int frame) {
		final Polyline contour = tracks.filaments().get(filament - 1).frames().get(frame - 1)
			.contour().orElseThrow();
		return contour.at(contour.length() / 2);
	}

	private static boolean same(final Point a, final Point b) {
		return a.distanceTo(b) < 2;
	}
}
