package io.github.knotresolver.ui.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.io.FramesCsv;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Session;

/** A review of a true result: a drawn movie of a knotted filament. */
class ReviewRepairTest {

	private static final Settings SETTINGS = Settings.DEFAULT.edit().threads(2).build();

	private static DrawnMovie drawn;
	private static ReviewModel model;

	@TempDir
	Path home;

	@BeforeAll
	static void open() throws InterruptedException {
		drawn = DrawnMovie.draw(DrawnMovie.waves(10, 80, 3.6), List.of(),
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), 0.05, 41);
		model = new ReviewModel(drawn.movie(), new Session(drawn.movie(), SETTINGS)::solve,
			List.of());
		model.atRest();
	}

	@AfterAll
	static void close() {
		model.close();
	}

	private static double error(final Polyline contour, final Polyline truth) {
		double sum = 0;
		for (int i = 0; i <= 40; i++)
			sum += contour.at(contour.length() * i / 40)
				.distanceTo(truth.at(truth.length() * i / 40)) / 41;
		return sum;
	}

	private double errorOf(final int frame) throws InterruptedException {
		return error(frame(model.atRest(), frame).contour().orElseThrow(),
			drawn.truth().get(frame - 1));
	}

	private static Observation frame(final Tracks tracks, final int frame) {
		return tracks.only().frames().get(frame - 1);
	}

	/** The wrong course is one that the frame's own picture allows. */
	@Test
	void aWrongFrameIsRightAfterOneWordAndTheFileRepeatsIt() throws Exception {
		final int wrong = model.tracks().orElseThrow().only().frames().stream()
			.filter(o -> o.alternatives().stream()
				.anyMatch(a -> error(a.contour(), drawn.truth().get(o.frame() - 1)) > 3))
			.mapToInt(Observation::frame).findFirst().orElseThrow();
		model.goTo(wrong);
		int course = 0;
		while (error(model.alternatives().get(course).contour(), drawn.truth().get(wrong - 1)) <= 3)
			course++;
		model.take(course);
		assertTrue(errorOf(wrong) > 3, "The frame is not wrong: " + errorOf(wrong));
		model.refuse();
		assertTrue(errorOf(wrong) < 1, "It is not mended: " + errorOf(wrong));
		assertTrue(model.changed().contains(wrong));
		assertEquals(1, model.said().size());
		assertRunIsTheSame();
		model.undo();
		assertTrue(errorOf(wrong) > 3);
		model.undo();
		assertTrue(errorOf(wrong) < 1);
	}

	@Test
	void placesTipsAndRefusalsAreRepeatedToTheByte() throws Exception {
		final Polyline truth = drawn.truth().get(4);
		model.goTo(5);
		model.through(truth.at(0.3 * truth.length()));
		model.through(truth.at(0.61 * truth.length()));
		model.tip(truth.last());
		model.goTo(8);
		model.refuse();
		model.atRest();
		model.refuse();
		assertRunIsTheSame();
		model.goTo(5);
		model.withdraw();
		model.goTo(8);
		model.withdraw();
		assertEquals(List.of(), model.said());
	}

	private void assertRunIsTheSame() throws Exception {
		final Path file = home.resolve(CorrectionsCsv.FILE);
		final Tracks reviewed = model.atRest();
		CorrectionsCsv.write(file, model.said());
		assertEquals(model.said(), CorrectionsCsv.read(file));
		final Tracks run = new Session(drawn.movie(),
			SETTINGS.edit().threads(1).constraints(CorrectionsCsv.read(file)).build())
			.solve(List.of(), Progress.NONE);
		assertEquals(written(run, "run"), written(reviewed, "reviewed"));
		assertNotEquals("", written(run, "run"));
	}

	private String written(final Tracks tracks, final String name) throws IOException {
		final MeasuredTracks measured = MeasuredTracks.of(tracks, Progress.NONE);
		final Path contours = home.resolve(name + ".csv"), frames = home.resolve(name + "-f.csv");
		ContoursCsv.write(contours, measured);
		FramesCsv.write(frames, measured);
		return Files.readString(contours) + Files.readString(frames);
	}
}
