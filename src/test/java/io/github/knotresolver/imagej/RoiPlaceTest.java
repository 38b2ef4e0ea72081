package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Color;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import ij.IJ;
import ij.ImagePlus;
import ij.gui.PointRoi;
import ij.gui.ProfilePlot;
import ij.gui.Roi;
import ij.process.ColorProcessor;
import ij.process.FloatProcessor;
import ij.process.ImageProcessor;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;

/** Contours lie where the filament is, in ImageJ's own drawing and profiles. */
class RoiPlaceTest {

	private static final Path LINES = Path.of("../shared/data/faults/lines.tif");

	/** A line of one pixel along a row or a column is drawn into exactly that. */
	@ParameterizedTest
	@CsvSource({"true", "false"})
	void overlayRunsThroughTheMiddleOfItsPixels(final boolean alongRow) {
		final ImagePlus image = new ImagePlus("dark", new ColorProcessor(40, 40));
		final double[] along = {5, 12, 20, 30}, across = {25, 25, 25, 25};
		final Roi roi = RoiConverter
			.polyline(alongRow ? Polyline.of(along, across) : Polyline.of(across, along));
		roi.setStrokeColor(Color.WHITE);
		roi.setStrokeWidth(1f);
		image.setOverlay(new ij.gui.Overlay(roi));
		final ImagePlus drawn = image.flatten();
		final double[] light = new double[40];
		for (int i = 0; i < 40; i++)
			light[i] = (alongRow
				? drawn.getProcessor().getPixel(15, i)
				: drawn.getProcessor().getPixel(i, 15)) & 0xff;
		final double[] expected = new double[40];
		expected[25] = 255;
		assertArrayEquals(expected, light, 1, Arrays.toString(light));
	}

	/** Of the overlay's two screen pixels a pixel, those of row 25 are drawn alike. */
	@Test
	void pictureOfTheOverlayHasTheLineInTheMiddleOfItsRow() {
		final Movie movie = new Movie("dark", ArrayImgs.unsignedBytes(60, 50, 2), Calibration.NONE);
		final Polyline contour = Polyline.of(new double[]{10, 25, 50}, new double[]{25, 25, 25});
		final ImagePlus overlay = OverlayRenderer.stack(TestImages.tracks(movie,
			RunOptions.parse(Map.of()).parameters(movie), List.of(contour, contour)),
			Progress.NONE);
		assertEquals(100, overlay.getHeight());
		final ImageProcessor ip = overlay.getStack().getProcessor(1);
		assertEquals(ip.getPixel(60, 50), ip.getPixel(60, 51));
		assertEquals(ip.getPixel(60, 49), ip.getPixel(60, 52));
		assertTrue((ip.getPixel(60, 50) & 0xffffff) != (ip.getPixel(60, 48) & 0xffffff));
	}

	/** The profile along the contour is brighter than beside it, on both sides alike. */
	@Test
	void profileIsThatOfTheFilament() {
		final FloatProcessor ip = new FloatProcessor(60, 50);
		for (int y = 0; y < 50; y++)
			for (int x = 0; x < 60; x++)
				ip.setf(x, y, (float) (100 * Math.exp(-0.5 * (y - 25) * (y - 25))));
		final ImagePlus image = new ImagePlus("line", ip);
		assertEquals(profile(image, 25.25), profile(image, 24.75), 1e-3);
		assertEquals(profile(image, 26), profile(image, 24), 1e-3);
		assertTrue(profile(image, 25) > profile(image, 25.25));
	}

	@Test
	void profilesOfTheLinesAreLargestOnTheirRow() {
		assumeTrue(Files.exists(LINES), "There is no " + LINES + " beside the checkout.");
		final ImagePlus image = IJ.openImage(LINES.toString());
		image.setSliceWithoutUpdate(3);
		final double on = profile(image, 25), above = profile(image, 24.5),
			below = profile(image, 25.5);
		assertTrue(on > above && on > below, above + " " + on + " " + below);
	}

	private static double profile(final ImagePlus image, final double row) {
		image.setRoi(RoiConverter
			.polyline(Polyline.of(new double[]{20, 30, 40, 50}, new double[]{row, row, row, row})));
		return Arrays.stream(new ProfilePlot(image).getProfile()).sum();
	}

	/** What a click on the middle of a pixel gives, at any magnification. */
	@Test
	void pointSelectionIsReadWhereItIsDrawn() {
		final ImagePlus image = new ImagePlus("dark", new ColorProcessor(40, 40));
		for (final Roi roi : new Roi[]{new PointRoi(12, 30), new PointRoi(12.0, 30.0)}) {
			image.setRoi(roi);
			assertEquals(new Point(12, 30), RoiConverter.point(image.getRoi()).orElseThrow());
		}
		image.setRoi(new PointRoi(12.25, 29.5));
		assertEquals(new Point(12.25, 29.5), RoiConverter.point(image.getRoi()).orElseThrow());
	}
}
