package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

import net.imglib2.position.FunctionRandomAccessible;
import net.imglib2.type.numeric.integer.UnsignedByteType;
import net.imglib2.view.Views;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import ij.IJ;
import ij.ImagePlus;
import ij.gui.Roi;
import ij.io.RoiDecoder;
import ij.io.RoiEncoder;
import ij.measure.ResultsTable;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.plot.MeasurementFolder;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.FilamentMeasurements;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.FinishedRun;
import io.github.knotresolver.run.MeasureRun;
import io.github.knotresolver.run.ResolveRun;
import io.github.knotresolver.run.RunReport;

/** A result with a clamped filament, a free one that leaves the view, and one that is lost. */
class SeveralFilamentsTest {

	private static final int FRAMES = 10;

	@TempDir
	Path home;
	private Path out;
	private final ImagePlus image = TestImages.movie(FRAMES, 8);
	private Tracks tracks;

	@BeforeEach
	void nameTheFolder() {
		System.setProperty("java.awt.headless", "true");
		out = home.resolve("result");
	}

	@Test
	void everyFileTellsTheFilament() throws IOException {
		write(true);
		final List<String> contours = lines("contours.csv");
		assertTrue(contours.get(0).endsWith(",filament"), contours.get(0));
		assertTrue(contours.get(1).startsWith("1,0,") && contours.get(1).endsWith(",1"));
		assertTrue(contours.get(contours.size() - 1).endsWith(",3"));
		final List<String> frames = lines("frames.csv");
		assertEquals(1 + 3 * FRAMES, frames.size());
		assertTrue(frames.get(0).endsWith(",filament,visible,checked"), frames.get(0));
		assertTrue(frames.get(1).endsWith(",1,1,0"), frames.get(1));
		assertTrue(frames.get(FRAMES + 4).endsWith(",3,0.5,0"), frames.get(FRAMES + 4));
		assertTrue(frames.get(FRAMES + 9).startsWith("9,absent,"), frames.get(FRAMES + 9));
		assertTrue(frames.get(FRAMES + 9).endsWith(",3,0,0"), frames.get(FRAMES + 9));
		assertTrue(frames.get(2 * FRAMES + 1).startsWith("1,lost,Gone.,"));
		assertEquals(List.of(
			"filament,anchor,first_frame,last_frame,length,length_se,frames_resolved,mean_confidence,unit,gliding_path,gliding_speed,time_unit",
			"1,clamped,1,10,20,0.025,10,0.9,µm,,,s", "3,free,1,7,10,,7,0.8,µm,1.5,0.125,s",
			"12,free,1,10,,,0,,µm,,,s"), lines("filaments.csv"));
		for (final String file : List.of("MTdata.csv", "MTdata-03.csv", "statsSummary-03.txt",
			"tangent_angle_kymograph.tif", "tangent_angle_kymograph-03.tif", "length-03.svg",
			"contours-03.png", "montage.png", "montage-01.png", "montage-03.png", "montage-12.png"))
			assertTrue(Files.size(out.resolve(file)) > 0, file);
		assertFalse(Files.exists(out.resolve("length-12.svg")));
		assertTrue(lines("MTdata-03.csv").get(0).startsWith("1,"));
	}

	@Test
	void reportTellsEachFilament() throws IOException {
		final List<String> report = RunReport.lines(write(false));
		assertEquals("movie: 3 filaments; 17 of 27 filament-frames resolved.", report.get(0));
		assertEquals("Filament 1 (clamped): frames 1-10, resolved in 10, length 20 µm.",
			report.get(1));
		assertEquals(
			"Filament 3 (free): frames 1-7, resolved in 7, length 10 µm, glides at 0.125 µm/s.",
			report.get(2));
		assertTrue(report.contains("Filament 12, frames lost: 1-10 (frames.csv says why)."),
			report.toString());
	}

	@Test
	void writtenContoursAreReadBackAndMeasuredEachByItself() throws IOException {
		write(false);
		final var read = ContoursCsv.readFilaments(out.resolve("contours.csv"));
		assertEquals(List.of(1, 3), List.copyOf(read.keySet()));
		assertEquals(7, read.get(3).size());
		final Polyline contour = tracks.filaments().get(1).frames().get(2).contour().orElseThrow();
		assertEquals(contour.last().x(), read.get(3).get(3).last().x(), 0.001);

		final List<ContourInput> inputs = ContourInput.readAll(out);
		assertEquals(List.of("result-01", "result-03"),
			inputs.stream().map(ContourInput::name).toList());
		assertEquals(List.of(1, 3), inputs.stream().map(ContourInput::filament).toList());
		assertEquals(FRAMES, inputs.get(1).contours().size());
		assertEquals(0.1, inputs.get(0).lengthErrorPx(), 1e-9);
		assertEquals(0, inputs.get(1).lengthErrorPx());
		assertEquals(0.25, inputs.get(1).calibration().pixelSize());

		final List<FilamentMeasurements> all = MeasureRun.parse(Map.of()).measure(inputs,
			Progress.NONE);
		final Path measured = home.resolve("measured");
		try (ResultFolder folder = ResultFolder.reserve(measured, ResultKind.MEASUREMENT, false,
			List.of())) {
			assertEquals(List.of(),
				MeasurementFolder.write(all, folder, true, true, Progress.NONE));
		}
		assertEquals(1 + 2 * FRAMES, Files.readAllLines(measured.resolve("frames.csv")).size());
		assertTrue(
			Files.readAllLines(measured.resolve("frames.csv")).get(FRAMES + 1).endsWith(",s,3"));
		assertTrue(Files.exists(measured.resolve("statsSummary-03.txt")));
		assertTrue(Files.exists(measured.resolve("tip_angle-03.png")));
		assertEquals(4, MeasurementFolder.report(all).size());
		// Measurements are contours again.
		assertEquals(2, ContourInput.readAll(measured).size());
	}

	@Test
	void olderFilesWithoutTheColumnAreOfFilamentOne() throws IOException {
		final Path file = home.resolve("contours.csv");
		Files.write(file, List.of("frame,index,x_px,y_px", "1,0,3,4", "1,1,13,4"));
		assertEquals(List.of(1), List.copyOf(ContoursCsv.readFilaments(file).keySet()));
		assertEquals(1, ContourInput.read(file).filament());
	}

	@Test
	void roisHaveNamesAndGroupsOfTheirFilaments() throws IOException {
		write(false);
		final List<Roi> rois = RoiConverter.forImage(image, 1).rois(tracks);
		assertEquals(17, rois.size());
		assertEquals("knot-01-0001", rois.get(0).getName());
		assertEquals("knot-03-0007", rois.get(16).getName());
		assertEquals(List.of(1, 3), List.of(rois.get(0).getGroup(), rois.get(16).getGroup()));
		final Roi decoded = RoiDecoder.openFromByteArray(RoiEncoder.saveAsByteArray(rois.get(16)));
		assertEquals(3, decoded.getGroup());
		assertEquals(rois.get(16).getFloatPolygon().npoints, decoded.getFloatPolygon().npoints);
		assertNotEquals(rois.get(0).getStrokeColor(), rois.get(16).getStrokeColor());
		final List<String> names = new ArrayList<>(rois.stream().map(Roi::getName).toList());
		assertEquals(names.stream().sorted().toList(), names);
	}

	@Test
	void tablesHaveTheFilament() throws IOException {
		final ContourTables tables = new ContourTables("movie", write(false));
		final ResultsTable frames = tables.frames(), filaments = tables.filaments(),
			contours = tables.contours();
		assertEquals(3 * FRAMES, frames.size());
		assertEquals(3, frames.getValue("filament", FRAMES));
		assertEquals(3, filaments.size());
		assertEquals("free", filaments.getStringValue("anchor", 1));
		assertEquals(7, filaments.getValue("last frame", 1));
		assertEquals(3, contours.getValue("filament", contours.size() - 1));
	}

	@Test
	void overlayHasAColourForEach() throws IOException {
		write(true);
		final ImagePlus overlay = IJ.openImage(out.resolve("overlay.tif").toString());
		assertEquals("1 resolved, 3 absent, 12 lost", overlay.getStack().getSliceLabel(9));
		final int first = overlay.getStack().getProcessor(1).getPixel(2 * 70 + 1, 2 * 10 + 1),
			second = overlay.getStack().getProcessor(1).getPixel(2 * 45 + 1, 2 * 50 + 1);
		assertEquals(hue(Palette.ofFilament(1).getRGB()), hue(first), 0.05);
		assertEquals(hue(Palette.ofFilament(3).getRGB()), hue(second), 0.05);
	}

	@Test
	void movieWithoutAnyFilamentIsWrittenToo() throws IOException {
		final MeasuredTracks result = write(true, List.of());
		assertEquals(1, lines("contours.csv").size());
		assertEquals(1, lines("frames.csv").size());
		assertEquals(1, lines("filaments.csv").size());
		assertEquals("movie: no filament was found in 10 frames.", RunReport.lines(result).get(0));
		assertTrue(Files.exists(out.resolve("montage.png")));
	}

	@Test
	void whatCannotBeDrawnCostsThePicturesAndNoNumber() throws IOException {
		final var tooLarge = Views
			.interval(new FunctionRandomAccessible<UnsignedByteType>(3, (place, pixel) -> {
				throw new OutOfMemoryError("Java heap space");
			}, UnsignedByteType::new), new long[3],
				new long[]{TestImages.WIDTH - 1, TestImages.HEIGHT - 1, FRAMES - 1});
		final ImageSource source = ImageSource.of(image);
		final FinishedRun outcome;
		try (ResultFolder folder = ResultFolder.reserve(out, ResultKind.RESOLVED_MOVIE, false,
			List.of())) {
			outcome = ResolveRun.of(Map.of()).read(source, Progress.NONE).resolve(
				(movie, settings, progress) -> tracks(
					new Movie("large", tooLarge, movie.calibration()), settings,
					List.of(filament(1, Anchor.CLAMPED, 80, 0.1,
						t -> seen(t, line(-10 + t, 10, 70 + t, 10), 0.9, 1)))),
				new FolderSink(folder, source, true), Progress.NONE);
		}
		assertEquals(1 + FRAMES, lines("frames.csv").size());
		assertTrue(Files.exists(out.resolve("tip_angle.svg")));
		for (final String picture : List.of("overlay.tif", "overlay.avi", "montage.png",
			"overlay.png")) {
			assertFalse(Files.exists(out.resolve(picture)), picture);
			assertTrue(
				outcome.report().contains(picture
					+ " was left out. There is not enough memory for this movie; give Java more."),
				outcome.report().toString());
			assertTrue(Files.readString(out.resolve("parameters.json"))
				.contains(picture + " was left out."), picture);
		}
	}

	private static float hue(final int rgb) {
		return Color.RGBtoHSB(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255, null)[0];
	}

	private List<String> lines(final String file) throws IOException {
		return Files.readAllLines(out.resolve(file));
	}

	private MeasuredTracks write(final boolean plots) throws IOException {
		return write(plots,
			List.of(
				filament(1, Anchor.CLAMPED, 80, 0.1,
					t -> seen(t, line(-10 + t, 10, 70 + t, 10), 0.9, 1)),
				filament(3, Anchor.FREE, Double.NaN, Double.NaN,
					t -> t > 7
						? Observation.without(t, FrameStatus.ABSENT, "It has left the view.")
						: seen(t, line(20 + t, 50, 60 + t, 50), 0.8, t == 4 ? 0.5 : 1)),
				filament(12, Anchor.FREE, Double.NaN, Double.NaN,
					t -> Observation.without(t, FrameStatus.LOST, "Gone."))));
	}

	private MeasuredTracks write(final boolean plots, final List<FilamentTrack> filaments)
		throws IOException {
		final ImageSource source = ImageSource.of(image);
		try (ResultFolder folder = ResultFolder.reserve(out, ResultKind.RESOLVED_MOVIE, false,
			List.of())) {
			return ResolveRun.of(Map.of()).read(source, Progress.NONE)
				.resolve((movie, settings, progress) -> tracks = tracks(movie, settings, filaments),
					new FolderSink(folder, source, plots), Progress.NONE)
				.result();
		}
	}

	private static Tracks tracks(final Movie movie, final Settings settings,
		final List<FilamentTrack> filaments) {
		return new Tracks(movie, settings, filaments, List.of("A note."));
	}

	private static FilamentTrack filament(final int id, final Anchor anchor, final double length,
		final double error, final IntFunction<Observation> frame) {
		return new FilamentTrack(id, anchor,
			anchor == Anchor.CLAMPED ? Optional.of(new Point(2, 10)) : Optional.empty(), length,
			error, IntStream.rangeClosed(1, FRAMES).mapToObj(frame).toList());
	}

	private static Observation seen(final int frame, final Polyline contour,
		final double confidence, final double visible) {
		return new Observation(frame, FrameStatus.RESOLVED, "", Optional.of(contour), 1, 2, 0.5,
			confidence, visible, List.of());
	}

	private static Polyline line(final double x0, final double y0, final double x1,
		final double y1) {
		return Polyline.of(new double[]{x0, x1}, new double[]{y0, y1}).divided(40);
	}
}
