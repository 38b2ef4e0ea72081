package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.zip.ZipInputStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import ij.IJ;
import ij.ImagePlus;
import ij.gui.Overlay;
import ij.gui.PointRoi;
import ij.gui.Roi;
import ij.io.RoiDecoder;
import ij.io.RoiEncoder;
import ij.measure.ResultsTable;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;

class ResultDisplayTest {

	private final ImagePlus image = TestImages.movie(4, 8);
	private final Movie movie = ImageMovie.of(image, InputOptions.DEFAULT);
	private final Tracks tracks = TestImages.resolve(movie, Settings.DEFAULT, Progress.NONE);

	@TempDir
	Path home;

	@Test
	void roiIsSubPixelWithNameAndPosition() throws IOException {
		final List<Roi> rois = RoiConverter.forStack(4).rois(tracks);
		assertEquals(List.of("knot-0001", "knot-0003", "knot-0004"),
			rois.stream().map(Roi::getName).toList());
		final Path file = home.resolve("RoiSet.zip");
		RoiConverter.writeSet(file, rois);
		final byte[] first = Files.readAllBytes(file);
		RoiConverter.writeSet(file, rois);
		assertTrue(Arrays.equals(first, Files.readAllBytes(file)));
		final List<Roi> read = read(file);
		assertEquals(3, read.size());
		final Roi roi = read.get(1);
		assertEquals("knot-0003", roi.getName());
		assertEquals(3, roi.getPosition());
		final var points = roi.getFloatPolygon();
		final var contour = tracks.only().frames().get(2).contour().get();
		assertEquals(contour.size(), points.npoints);
		for (int i = 0; i < points.npoints; i++) {
			assertEquals(contour.x(i), points.xpoints[i], 1e-4);
			assertEquals(contour.y(i), points.ypoints[i], 1e-4);
		}
	}

	@Test
	void roiOfAChannelHasThePositionOfTheHyperstack() {
		final ImagePlus two = IJ.createHyperStack("two", 80, 60, 2, 1, 4, 8);
		final Roi roi = RoiConverter.forImage(two, 2).rois(tracks).get(1);
		assertEquals(List.of(2, 1, 3),
			List.of(roi.getCPosition(), roi.getZPosition(), roi.getTPosition()));
		final Roi decoded = RoiDecoder.openFromByteArray(RoiEncoder.saveAsByteArray(roi));
		assertEquals(3, decoded.getTPosition());
	}

	@Test
	void roiOfSlicesThatAreFramesStandsOnItsSlice() {
		final Roi roi = RoiConverter.forImage(IJ.createHyperStack("z", 80, 60, 2, 4, 1, 8), 2)
			.rois(tracks).get(1);
		assertEquals(List.of(2, 3, 1),
			List.of(roi.getCPosition(), roi.getZPosition(), roi.getTPosition()));
	}

	@Test
	void positionsAreThoseOfTheImageBeforeItWasClosed() {
		final ImagePlus two = IJ.createHyperStack("two", 80, 60, 2, 1, 4, 8);
		final RoiConverter rois = RoiConverter.forImage(two, 2);
		two.flush();
		assertEquals(3, rois.rois(tracks).get(1).getTPosition());
	}

	@Test
	void overlayReplacesTheEarlierOneAndLeavesPixelsAndOtherShapes() {
		final byte[] before = ((byte[]) image.getStack().getPixels(1)).clone();
		image.setOverlay(new Overlay(new Roi(1, 1, 5, 5)));
		new ResultDisplay(image, tracks, RoiConverter.forImage(image, 1)).overlay();
		final int once = image.getOverlay().size();
		new ResultDisplay(image, tracks, RoiConverter.forImage(image, 1)).overlay();
		assertEquals(once, image.getOverlay().size());
		assertEquals(1 + 3 * 16, once);
		assertEquals(1, image.getOverlay().get(1).getPosition());
		assertTrue(Arrays.equals(before, (byte[]) image.getStack().getPixels(1)));
	}

	@Test
	void tablesHaveUnitsAndARowForEveryFrame() {
		final ContourTables tables = new ContourTables("movie",
			MeasuredTracks.of(tracks, Progress.NONE));
		final ResultsTable frames = tables.frames();
		assertEquals(4, frames.size());
		assertEquals("lost", frames.getStringValue("status", 1));
		assertEquals(2, frames.getValue("time [s]", 1));
		assertTrue(Double.isNaN(frames.getValue("length [µm]", 1)));
		assertEquals(20, frames.getValue("length [µm]", 0), 0.5);
		final ResultsTable contours = tables.contours();
		assertEquals(3 * 101, contours.size());
		assertEquals(12, contours.getValue("x [px]", 0));
		assertEquals(3, contours.getValue("x [µm]", 0), 1e-4);
		assertTrue(contours.columnExists("curvature [1/µm]"));
	}

	@Test
	void pointSelectionIsAPixelCentre() {
		assertEquals(Optional.of(new Point(12, 30)), RoiConverter.point(new PointRoi(12, 30)));
		assertEquals(Optional.of(new Point(12.25, 30)),
			RoiConverter.point(new PointRoi(12.25, 30.0)));
		assertEquals(Optional.empty(), RoiConverter.point(new Roi(1, 2, 3, 4)));
		assertEquals(Optional.empty(), RoiConverter.point(null));
	}

	private static List<Roi> read(final Path zip) throws IOException {
		final List<Roi> rois = new ArrayList<>();
		try (ZipInputStream in = new ZipInputStream(Files.newInputStream(zip))) {
			while (in.getNextEntry() != null)
				rois.add(RoiDecoder.openFromByteArray(in.readAllBytes()));
		}
		return rois;
	}
}
