package io.github.knotresolver.imagej.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;

import org.jfree.chart.JFreeChart;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import ij.IJ;
import ij.ImagePlus;
import ij.gui.Plot;
import ij.measure.ResultsTable;
import ij.process.ColorProcessor;
import ij.process.ImageProcessor;
import ij.process.ImageStatistics;
import io.github.knotresolver.CancelledProgress;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

class FiguresTest {

	private static final int MISSING = 4;

	@TempDir
	private Path folder;

	@BeforeAll
	static void needNoDisplay() {
		System.setProperty("java.awt.headless", "true");
	}

	@Test
	void everyFigureIsWrittenForPrint() throws IOException {
		final List<Path> files = writeAll(folder, movie(20), Progress.NONE);
		assertEquals(16, files.size());
		for (final Path file : files)
			assertTrue(Files.size(file) > 1000, file.toString());
		final BufferedImage png = ImageIO.read(folder.resolve("curvature_kymograph.png").toFile());
		assertEquals(1800, png.getWidth());
		final String svg = Files.readString(folder.resolve("end_to_end.svg"));
		assertTrue(svg.contains("Time [s]"), "axis with unit");
	}

	@Test
	void sameMeasurementsGiveTheSameBytes() throws IOException {
		final Path a = Files.createDirectory(folder.resolve("a")),
			b = Files.createDirectory(folder.resolve("b"));
		writeAll(a, movie(12), Progress.NONE);
		for (final Path file : writeAll(b, movie(12), Progress.NONE))
			assertArrayEquals(Files.readAllBytes(a.resolve(file.getFileName())),
				Files.readAllBytes(file), file.getFileName().toString());
	}

	@Test
	void svgIsTheSameInAnyLocaleAndWellFormed() throws Exception {
		final Path a = Files.createDirectory(folder.resolve("a")),
			b = Files.createDirectory(folder.resolve("b"));
		writeAll(a, movie(12), Progress.NONE);
		final Locale before = Locale.getDefault();
		Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
		try {
			writeAll(b, movie(12), Progress.NONE);
		} finally {
			Locale.setDefault(before);
		}
		final DocumentBuilder parser = xmlParser();
		for (final String name : Figures.charts(movie(12)).keySet()) {
			final Path svg = a.resolve(name + ".svg");
			assertEquals(Files.readString(svg), Files.readString(b.resolve(name + ".svg")), name);
			assertEquals("svg", parser.parse(svg.toFile()).getDocumentElement().getTagName());
		}
	}

	/** Reads no DTD from anywhere. */
	private static DocumentBuilder xmlParser() throws ParserConfigurationException {
		final DocumentBuilderFactory factory = DocumentBuilderFactory.newDefaultInstance();
		factory.setFeature("http://apache.org/xml/features/nonvalidating/load-external-dtd", false);
		return factory.newDocumentBuilder();
	}

	@Test
	void kymographsAreSharpInSvg() throws IOException {
		writeAll(folder, movie(12), Progress.NONE);
		final String svg = Files.readString(folder.resolve("curvature_kymograph.svg"));
		assertTrue(svg.contains("image-rendering=\"optimizeSpeed\""), "frames are not blurred");
		assertTrue(svg.contains("data:image/png;base64,"), "the picture is in the file");
	}

	@Test
	void kymographImagesShowNumbersInColoursAndMissingFramesGrey() {
		final MovieMeasurements m = movie(10);
		for (final ImagePlus image : List.of(Figures.tangentAngleImage(m),
			Figures.curvatureImage(m))) {
			final ImageProcessor pixels = image.getProcessor();
			final ColorProcessor shown = pixels.convertToColorProcessor();
			for (int i = 0; i < pixels.getPixelCount(); i++)
				assertEquals(Float.isNaN(pixels.getf(i)),
					ColourMap.MISSING.getRGB() == shown.get(i), "pixel " + i);
			final ImageStatistics range = ImageStatistics.getStatistics(pixels);
			assertTrue(pixels.getMin() < range.min && pixels.getMax() >= range.max,
				"all numbers are in range");
		}
	}

	@Test
	void kymographImagesAreCalibratedAndMissingFramesAreNaN() throws IOException {
		Figures.writeKymographs(new Pictures(folder), "", movie(10));
		final ImagePlus image = IJ.openImage(folder.resolve("curvature_kymograph.tif").toString());
		assertEquals(32, image.getBitDepth());
		assertEquals(10, image.getHeight());
		assertEquals(0.1, image.getCalibration().pixelWidth, 0.001);
		assertEquals(2, image.getCalibration().pixelHeight, 1e-9);
		assertEquals("s", image.getCalibration().getYUnit());
		assertEquals(0.25, image.getProcessor().getf(20, 2), 0.01);
		assertTrue(Float.isNaN(image.getProcessor().getf(20, MISSING)));
	}

	@Test
	void missingFramesAreGreyInTheChart() {
		final JFreeChart chart = Figures.charts(movie(10)).get("tangent_angle_kymograph");
		final BufferedImage picture = chart.createBufferedImage(600, 400);
		int grey = 0;
		for (int x = 0; x < 600; x++)
			if (new Color(picture.getRGB(x, 200)).equals(ColourMap.MISSING))
				grey++;
		// One of ten frames of a chart that is about 400 points wide.
		assertTrue(grey > 25 && grey < 60, grey + " grey pixels");
	}

	@Test
	void twoSidedColoursAreWhiteAtZeroAndDifferAtTheEnds() {
		final ColourMap map = ColourMap.twoSided(2);
		assertEquals(new Color(0xf7f7f7), map.colour(0));
		assertEquals(map.colour(-2), map.colour(-5));
		assertTrue(map.colour(-2).getBlue() > map.colour(-2).getRed());
		assertTrue(map.colour(2).getRed() > map.colour(2).getBlue());
	}

	@Test
	void livePlotsAndTablesHoldTheNumbersWithUnits() {
		final MovieMeasurements m = movie(10);
		final Plot plot = LivePlots.series(m, Quantity.LENGTH);
		assertEquals(10, plot.getXValues().length);
		assertTrue(Float.isNaN(plot.getYValues()[MISSING]));
		final Plot all = LivePlots.contours(m);
		final double[] limits = all.getLimits();
		assertEquals(limits[1] - limits[0], limits[2] - limits[3], 1e-9,
			"true shapes, y downwards");
		final ResultsTable table = LivePlots.table(m);
		assertEquals(10, table.size());
		assertEquals(2 * Math.PI, table.getValue("length [µm]", 0), 0.01);
		assertTrue(Double.isNaN(table.getValue("tip_angle [rad]", MISSING)));
		assertTrue(table.columnExists("bending_energy_se [1/µm]"));
		assertFalse(table.columnExists("crossings_se"));
	}

	@Test
	void aPlaceInAFigureLeadsToItsFrame() {
		final MovieMeasurements m = movie(10);
		final BufferedImage paper = new BufferedImage(600, 400, BufferedImage.TYPE_INT_RGB);
		for (final LiveFigure figure : LiveFigure.of(m)) {
			assertEquals(OptionalInt.empty(), figure.frameAt(new Point2D.Double(300, 150)));
			figure.draw(paper.createGraphics(), 600, 400, 3);
			final List<Integer> frames = IntStream.range(0, 600)
				.mapToObj(x -> figure.frameAt(new Point2D.Double(x, 150)))
				.filter(OptionalInt::isPresent).map(OptionalInt::getAsInt).distinct().toList();
			if (figure.key().endsWith("_spectrum"))
				assertEquals(List.of(), frames, figure.key());
			else if (!figure.key().equals("contours"))
				assertEquals(IntStream.rangeClosed(1, 10).boxed().toList(), frames, figure.key());
			else
				assertFalse(frames.isEmpty() || frames.contains(MISSING + 1), frames.toString());
		}
	}

	@Test
	void cancelStopsDrawing() {
		final Progress cancelled = new CancelledProgress();
		assertThrows(CancelledException.class, () -> writeAll(folder, movie(10), cancelled));
	}

	private static List<Path> writeAll(final Path folder, final MovieMeasurements m,
		final Progress progress) throws IOException {
		Figures.write(new Pictures(folder), "", m, progress);
		try (Stream<Path> files = Files.list(folder)) {
			return files.sorted().toList();
		}
	}

	/** Quarters of a circle of 40 px that swing to and fro. */
	private static MovieMeasurements movie(final int frames) {
		final List<Optional<Polyline>> contours = new ArrayList<>();
		for (int f = 0; f < frames; f++) {
			final double[] x = new double[64], y = new double[64];
			for (int i = 0; i < 64; i++) {
				final double a = Math.PI / 2 * i / 63 + 0.3 * Math.sin(0.9 * f);
				x[i] = 100 + 40 * Math.cos(a);
				y[i] = 100 + 40 * Math.sin(a);
			}
			contours.add(f == MISSING ? Optional.empty() : Optional.of(Polyline.of(x, y)));
		}
		return MovieMeasurements.of("swing", contours, new Calibration(0.1, "µm", 2, "s"));
	}
}
