package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.SortedMap;
import java.util.stream.IntStream;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.FrameView;

/** The sample movie on its way to graphs, as it is and after what cameras and lamps may do to it. */
class PreparedMovieTest {

	private static final int FRAMES = 8;
	private static final Movie SAMPLE = ImageMovie.of(SampleMovie.open(), InputOptions.DEFAULT);

	@TempDir
	private Path folder;

	/** What happens to a pixel. */
	private interface Change {

		double of(int x, int y, int t, double value);
	}

	private static Movie changed(final Change change) {
		final int width = SAMPLE.width(), height = SAMPLE.height();
		final float[] pixels = new float[width * height * FRAMES];
		for (int t = 0; t < FRAMES; t++) {
			final double[] frame = Pixels.doubles(SAMPLE.frame(t));
			for (int i = 0; i < frame.length; i++)
				pixels[t * frame.length + i] = (float) change.of(i % width, i / width, t, frame[i]);
		}
		return new Movie("changed", ArrayImgs.floats(pixels, width, height, FRAMES),
			SAMPLE.calibration());
	}

	private static PreparedMovie prepared(final Movie movie, final List<String> told) {
		return PreparedMovie.of(movie, Settings.DEFAULT,
			IntStream.rangeClosed(1, movie.size()).boxed().toList(), Workers.HERE, new Progress() {

				@Override
				public void report(final String stage, final double fraction) {
				}

				@Override
				public void note(final String sentence) {
					told.add(sentence);
				}

				@Override
				public boolean isCancelled() {
					return false;
				}
			});
	}

	private static PreparedMovie prepared(final Movie movie) {
		return prepared(movie, new ArrayList<>());
	}

	@Test
	void theSkeletonIsTheFilamentAndNothingElse() throws IOException {
		requireTruth(prepared(changed((x, y, t, v) -> v)), 0.98, 0.98);
	}

	@Test
	void gradientHazeAndHotPixelsChangeLittle() throws IOException {
		final Random random = new Random(6);
		requireTruth(prepared(changed((x, y, t, v) -> v + 0.8 * x + 40 * Math.sin(y / 20.0)
			+ (random.nextInt(500) == 0 ? 300 : 0))), 0.97, 0.95);
	}

	@Test
	void darkLinesAreInvertedAndSaid() throws IOException {
		final List<String> told = new ArrayList<>();
		final PreparedMovie dark = prepared(changed((x, y, t, v) -> 255 - v), told);
		assertEquals(List.of(EvidenceNotes.DARK), dark.notes());
		assertEquals(dark.notes(), told, "said while the work goes on");
		requireTruth(dark, 0.98, 0.98);
	}

	@Test
	void blankAndFlashedFramesAreLostAndNoOther() throws IOException {
		final PreparedMovie prepared = prepared(
			changed((x, y, t, v) -> t == 2 ? 3 + (x * 31 + y * 17) % 5 : t == 5 ? 255 : v));
		assertEquals(List.of(3, 6), prepared.lost().stream().map(o -> o.frame()).toList());
		assertTrue(prepared.notes().get(0).startsWith("Blank frames: 2"),
			prepared.notes().toString());
		requireTruth(prepared, 0.98, 0.98);
	}

	@Test
	void aSaturatedBeadElsewhereSaysNothingAboutStrands() {
		final PreparedMovie plain = prepared(changed((x, y, t, v) -> v));
		final PreparedMovie bead = prepared(
			changed((x, y, t, v) -> Math.hypot(x - 8, y - 46) < 5 ? 255 : v));
		assertEquals(plain.kinds(), bead.kinds());
		assertEquals(2, bead.kinds().size());
	}

	@Test
	void aMovieThatIsClippedAtTheStrandSaturates() {
		final PreparedMovie clipped = prepared(changed((x, y, t, v) -> Math.min(90, v)));
		assertEquals(Set.of(LineModel.Kind.SATURATING), clipped.kinds());
		assertTrue(clipped.notes().stream().anyMatch(n -> n.startsWith("Saturated: ")),
			clipped.notes().toString());
	}

	@Test
	void onlyTheBoxAroundTheLinesIsWorkedOn() {
		final int margin = 100, width = SAMPLE.width() + 2 * margin;
		final int height = SAMPLE.height() + 2 * margin;
		final Random random = new Random(7);
		final float[] pixels = new float[width * height * FRAMES];
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = (float) (20 + 4 * random.nextGaussian());
		for (int t = 0; t < FRAMES; t++) {
			final double[] frame = Pixels.doubles(SAMPLE.frame(t));
			for (int i = 0; i < frame.length; i++)
				pixels[(t * height + i / SAMPLE.width() + margin) * width + i % SAMPLE.width()
					+ margin] = (float) frame[i];
		}
		final PreparedMovie prepared = prepared(new Movie("field",
			ArrayImgs.floats(pixels, width, height, FRAMES), SAMPLE.calibration()));
		final FrameView first = prepared.frames().get(0);
		assertTrue(first.light().width() < width - 120 && first.light().height() < height - 120,
			first.light().width() + " x " + first.light().height());
		final Point there = new Point(150, 160);
		final Point back = prepared.pixels().out(prepared.pixels().in(there));
		assertEquals(0, there.distanceTo(back), 1e-9);
	}

	private void requireTruth(final PreparedMovie prepared, final double recall,
		final double precision) throws IOException {
		final Path copy = folder.resolve("truth.csv");
		try (InputStream in = SampleMovie.class
			.getResourceAsStream("/io/github/knotresolver/sample/knotted-filament-truth.csv")) {
			Files.copy(in, copy);
		}
		final SortedMap<Integer, Polyline> truth = ContoursCsv.read(copy);
		for (final FrameView view : prepared.frames()) {
			final FrameEvidence e = view.evidence().orElseThrow();
			final List<Point> found = IntStream.range(0, e.size())
				.mapToObj(i -> prepared.pixels().out(new Point(e.x(i), e.y(i)))).toList();
			final Polyline curve = truth.get(view.frame());
			final List<Point> real = IntStream.range(0, curve.size()).mapToObj(curve::point)
				.toList();
			assertTrue(share(real, found) >= recall,
				"frame " + view.frame() + " recall " + share(real, found));
			assertTrue(share(found, real) >= precision,
				"frame " + view.frame() + " precision " + share(found, real));
		}
	}

	/** The share of points that have one of the others within 3 px. */
	private static double share(final List<Point> points, final List<Point> others) {
		return (double) points.stream()
			.filter(p -> others.stream().anyMatch(q -> q.distanceTo(p) < 3)).count()
			/ points.size();
	}
}
