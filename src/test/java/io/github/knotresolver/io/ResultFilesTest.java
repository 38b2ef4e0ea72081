package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;

class ResultFilesTest {

	private static final Calibration CALIBRATION = new Calibration(0.5, "µm", 2, "s");

	@TempDir
	Path home;

	@Test
	void everyFileHasItsColumnsAndUnits() throws IOException {
		final Tracks tracks = tracks(RunOptions.parse(Map.of()));
		final MeasuredTracks result = MeasuredTracks.of(tracks, Progress.NONE);
		ContoursCsv.write(home.resolve("c"), result);
		FramesCsv.write(home.resolve("f"), result);
		OriginalFiles.writeContours(home.resolve("m"), result.filaments().get(0));

		final List<String> contours = Files.readAllLines(home.resolve("c"));
		assertEquals(
			"frame,index,x_px,y_px,x,y,arc_length,tangent_angle,curvature,unit,pixel_size,filament",
			contours.get(0));
		assertEquals("1,0,2.000,5.000,1,2.5,0,0,0,µm,0.5,1", contours.get(1));
		assertEquals("1,20,22.000,5.000,11,2.5,10,0,0,µm,0.5,1", contours.get(21));
		assertEquals("3,0,2.000,5.000,1,2.5,0,0.927295,0,µm,0.5,1", contours.get(22));
		final List<String> rows = Files.readAllLines(home.resolve("f"));
		assertEquals(
			"frame,status,reason,length,end_to_end,tip_angle,junctions,crossings,candidates,cost,confidence,unit,filament,visible,checked",
			rows.get(0));
		assertEquals("1,resolved,,10,10,0,2,0,5,1.25,0.875,µm,1,1,0", rows.get(1));
		assertEquals("2,lost,\"Gone, it seems.\",,,,0,0,0,,,µm,1,,0", rows.get(2));
		assertEquals("3,corrected,,10,10,0.927295,2,0,5,1.25,0.875,µm,1,1,1", rows.get(3));
		assertEquals("1,3.000,6.000", Files.readAllLines(home.resolve("m")).get(0));
		assertTrue(!Files.readString(home.resolve("f")).contains("\r"));
	}

	@Test
	void summaryIsOneRow() throws IOException {
		final Tracks tracks = tracks(RunOptions.parse(Map.of("fixed_end", "2,5", "length", "10")));
		SummaryCsv.write(home.resolve("s"), MeasuredTracks.of(tracks, Progress.NONE),
			InputOptions.DEFAULT);
		final List<String> rows = Files.readAllLines(home.resolve("s"));
		assertEquals(2, rows.size());
		assertTrue(rows.get(1).startsWith("a movie.tif,3,2,10,10,0,10,10,µm,,,,Hz,"), rows.get(1));
		assertTrue(rows.get(1).endsWith(
			",\"fixed_end=2.0,5.0 threshold=otsu iterations=10 contraction_bias=0.4 smooth_factor=0.2 segmentation=evidence polarity=auto candidates=trails resolver=movie length=10.0 length_model=auto filaments=auto anchor=auto refine=true channel=1 z_as_time=false pixel_size=0.5 unit=µm frame_interval=2.0\",1"),
			rows.get(1));
	}

	@Test
	void optionsOfTheParametersFileRepeatTheRun() throws IOException {
		final Map<String, String> texts = Map.ofEntries(Map.entry("fixed_end", "2,5"),
			Map.entry("threshold", "0.3"), Map.entry("iterations", "7"),
			Map.entry("contraction_bias", "-0.5"), Map.entry("smooth_factor", "1"),
			Map.entry("log_size", "9"), Map.entry("log_sigma", "1.5"),
			Map.entry("candidates", "paper"), Map.entry("resolver", "paper"),
			Map.entry("length", "6"), Map.entry("length_model", "free"),
			Map.entry("refine", "false"), Map.entry("frames", "1-3"),
			Map.entry("ignore_frames", "2"));
		final Tracks tracks = tracks(RunOptions.parse(texts));
		ParametersJson.write(home.resolve("p"), tracks, InputOptions.DEFAULT, Optional.empty(),
			List.of());
		final JsonObject json = JsonParser.parseString(Files.readString(home.resolve("p")))
			.getAsJsonObject();
		final Map<String, String> read = new TreeMap<>();
		json.getAsJsonObject("options").entrySet().forEach(
			e -> read.put(e.getKey(), e.getValue().isJsonNull() ? "" : e.getValue().getAsString()));
		assertEquals(tracks.settings(), RunOptions.parse(read).parameters(tracks.movie()));
		assertEquals("KnotResolver", json.get("program").getAsString());
		assertEquals("2.000,5.000", json.getAsJsonObject("found").get("fixed_end").getAsString());
	}

	@Test
	void statisticsHaveTheOriginalsFormat() throws IOException {
		final MeasuredTracks result = MeasuredTracks.of(tracks(RunOptions.parse(Map.of())),
			Progress.NONE);
		OriginalFiles.writeStatistics(home.resolve("s"), result.filaments().get(0), result);
		assertEquals("""
			Statistics Summary
			------------------
			Scaling Factor: 0.50000
			Time Step: 2.00
			Distance ignored from end (microns): 0.00
			Dominant Frequency (Hz): NaN

			Mean Length, Median Length, Std Length, Min Length, Max Length
			10.00, 10.00, 0.00, 10.00, 10.00
			Frame, Length (micron), Tip Angle, Tip Angle (smooth), EndToEndDistance (micron)
			1, 10.000, 0.000, 0.000, 10.000
			3, 10.000, -53.130, -53.130, 10.000
			""", Files.readString(home.resolve("s")));
	}

	@Test
	void contoursAreReadBack() throws IOException {
		final Tracks tracks = tracks(RunOptions.parse(Map.of()));
		final Path file = home.resolve("c.csv");
		ContoursCsv.write(file, MeasuredTracks.of(tracks, Progress.NONE));
		final Map<Integer, Polyline> read = ContoursCsv.read(file);
		assertEquals(List.of(1, 3), List.copyOf(read.keySet()));
		final Polyline written = tracks.only().frames().get(2).contour().get();
		assertEquals(written.size(), read.get(3).size());
		for (int i = 0; i < written.size(); i++)
			assertEquals(0, written.point(i).distanceTo(read.get(3).point(i)), 1e-3);
	}

	@ParameterizedTest
	@CsvSource({"0.1234567, 0.123457", "1234567.8, 1234570", "-0.00001234567, -0.0000123457",
		"2, 2", "0, 0", "NaN, ''", "1e-12, 0", "-3.4e20, -3.4E+20", "100, 100"})
	void numbersHaveSixDigits(final double value, final String text) {
		assertEquals(text, NumberText.significant(value));
	}

	/** Frame 1 along x, frame 2 lost, frame 3 along y and corrected. */
	private static Tracks tracks(final RunOptions options) {
		final Movie movie = new Movie("a movie.tif", ArrayImgs.unsignedBytes(40, 40, 3),
			CALIBRATION);
		return new Tracks(movie, options.parameters(movie),
			List.of(new FilamentTrack(1, Anchor.CLAMPED, Optional.of(new Point(2, 5)), 20, 0.1,
				List.of(frame(1, FrameStatus.RESOLVED, 1, 0),
					Observation.without(2, FrameStatus.LOST, "Gone, it seems."),
					frame(3, FrameStatus.CORRECTED, 0.6, 0.8)))),
			List.of());
	}

	private static Observation frame(final int number, final FrameStatus status, final double dx,
		final double dy) {
		final double[] x = new double[21], y = new double[21];
		for (int i = 0; i <= 20; i++) {
			x[i] = 2 + dx * i;
			y[i] = 5 + dy * i;
		}
		return new Observation(number, status, "", Optional.of(Polyline.of(x, y)), 2, 5, 1.25,
			0.875);
	}
}
