package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import ij.ImagePlus;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.ParametersJson;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;

/** From the image's unit to a result folder and back: no unit is lost on the way. */
class UnitsOfAResultTest {

	private static final int FRAMES = 24;

	@TempDir
	Path home;

	@ParameterizedTest
	@CsvSource({"5000,ms", "5,s", "5,sec", "0.0833333333333333333,min", "5e6,usec"})
	void unitOfTimeDoesNotChangeFrequencies(final double interval, final String unit)
		throws IOException {
		final ImagePlus image = TestImages.movie(FRAMES, 8);
		image.getCalibration().frameInterval = interval;
		image.getCalibration().setTimeUnit(unit);
		final RunOptions options = RunOptions.parse(Map.of());
		final Movie movie = ImageMovie.of(image, options.input());
		write(TestImages.resolve(movie, options.parameters(movie), Progress.NONE));
		final ContourInput read = ContourInput.read(home);
		assertEquals(5, read.calibration().frameInterval(), 1e-12);
		assertEquals(new Calibration(0.25, "µm", read.calibration().frameInterval(), "s"),
			read.calibration());
		final String json = Files.readString(home.resolve(ParametersJson.FILE));
		assertTrue(json.contains("\"time_unit\": \"s\""), json);
	}

	private void write(final Tracks tracks) throws IOException {
		ContoursCsv.write(home.resolve(ContoursCsv.FILE), MeasuredTracks.of(tracks, Progress.NONE));
		ParametersJson.write(home.resolve(ParametersJson.FILE), tracks, InputOptions.DEFAULT,
			Optional.empty(), List.of());
	}

	/** Alone, too, the table of contours tells its unit to the last digit. */
	@Test
	void tableOfContoursTellsTheSizeOfAPixel() throws IOException {
		final ImagePlus image = TestImages.movie(4, 8);
		image.getCalibration().pixelWidth = image.getCalibration().pixelHeight = 0.10612345;
		final RunOptions options = RunOptions.parse(Map.of());
		final Movie movie = ImageMovie.of(image, options.input());
		write(TestImages.resolve(movie, options.parameters(movie), Progress.NONE));
		assertEquals(new Calibration(0.10612345, "µm", 1, "frame"),
			ContourInput.read(home.resolve(ContoursCsv.FILE)).calibration());
	}

	/**
	 * x and y draw one curve, of which arc length, tangent angle and curvature are;
	 * x_px and y_px are the contour as it was found.
	 */
	@Test
	void oneRowIsOneCurve() throws IOException {
		final long seed = 11;
		final Random random = new Random(seed);
		final int n = 200;
		final double[] px = new double[n + 1], py = new double[n + 1];
		for (int i = 0; i <= n; i++) {
			px[i] = 80 + 50 * Math.cos(0.02 * i) + 0.3 * random.nextGaussian();
			py[i] = 60 + 50 * Math.sin(0.02 * i) + 0.3 * random.nextGaussian();
		}
		final Movie movie = new Movie("noisy", ArrayImgs.unsignedBytes(160, 120, 2),
			new Calibration(0.5, "µm", 1, "s"));
		write(TestImages.tracks(movie, RunOptions.parse(Map.of()).parameters(movie),
			List.of(Polyline.of(px, py), Polyline.of(px, py))));
		final double[][] rows = Files.readAllLines(home.resolve(ContoursCsv.FILE)).stream().skip(1)
			.limit(n + 1)
			.map(line -> IntStream.range(2, 9)
				.mapToDouble(k -> Double.parseDouble(line.split(",")[k])).toArray())
			.toArray(double[][]::new);
		double drawn = 0, moved = 0;
		for (int i = 0; i <= n; i++) {
			assertEquals(0, new Point(px[i], py[i]).distanceTo(new Point(rows[i][0], rows[i][1])),
				1e-3);
			moved = Math.max(moved, Math.hypot(rows[i][2] / 0.5 - px[i], rows[i][3] / 0.5 - py[i]));
			if (i == 0)
				continue;
			drawn += Math.hypot(rows[i][2] - rows[i - 1][2], rows[i][3] - rows[i - 1][3]);
			assertEquals(drawn, rows[i][4], 0.005 * drawn + 0.01, "arc length, point " + i);
			if (i == n)
				continue;
			final double angle = Math.atan2(rows[i + 1][3] - rows[i - 1][3],
				rows[i + 1][2] - rows[i - 1][2]);
			assertEquals(0, Math.IEEEremainder(angle - rows[i][5], 2 * Math.PI), 0.06,
				"tangent angle, point " + i);
		}
		assertTrue(moved > 0.3, "The noise of 0.3 px is in x and y: " + moved);
	}
}
