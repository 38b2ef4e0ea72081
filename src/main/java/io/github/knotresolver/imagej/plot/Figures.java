package io.github.knotresolver.imagej.plot;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

import org.jfree.chart.ChartUtils;
import org.jfree.chart.JFreeChart;

import ij.ImagePlus;
import ij.io.FileSaver;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.progress.Progress;

/** All figures of a measured movie, as files. */
public final class Figures {

	/** In a column of 85 mm letters of 14 points are then letters of 7.5. */
	private static final int WIDTH = 450, HEIGHT = 300, SQUARE_WIDTH = 440, SQUARE_HEIGHT = 380;
	/** PNG pixels for each point of a chart: 1800 pixels for a page's width. */
	private static final int PNG_SCALE = 4;
	private static final String CONTOURS = "contours";

	private Figures() {
	}

	/**
	 * The figures as JFreeChart charts, by file name without ending: {@code
	 * contours, tangent_angle_kymograph, curvature_kymograph, end_to_end, length,
	 * tip_angle, tip_angle_spectrum}, or the spectra of other quantities that were
	 * chosen. A spectrum is left out if fewer than eight frames have a contour.
	 *
	 * @param m the measurements
	 * @return the charts, in a fixed order
	 */
	public static Map<String, JFreeChart> charts(final MovieMeasurements m) {
		final Map<String, JFreeChart> charts = new LinkedHashMap<>();
		charts.put(CONTOURS, ContoursChart.of(m));
		charts.put("tangent_angle_kymograph", KymographChart.tangentAngle(m));
		charts.put("curvature_kymograph", KymographChart.curvature(m));
		for (final Quantity q : List.of(Quantity.END_TO_END, Quantity.LENGTH, Quantity.TIP_ANGLE))
			charts.put(q.key(), SeriesChart.of(m, q));
		for (final Quantity q : m.spectra())
			SpectrumChart.of(m, q).ifPresent(c -> charts.put(q.key() + "_spectrum", c));
		return charts;
	}

	/**
	 * Writes every chart as PNG and SVG, and the kymographs as calibrated 32-bit
	 * TIFF. Works without a display.
	 *
	 * @param folder an existing folder
	 * @param m the measurements
	 * @param progress told how far it is; may cancel
	 * @return the files, in a fixed order
	 * @throws IOException if the disk says no
	 */
	public static List<Path> writeAll(final Path folder, final MovieMeasurements m,
		final Progress progress) throws IOException {
		final List<Path> files = new ArrayList<>(writeKymographs(folder, m));
		final Map<String, JFreeChart> charts = charts(m);
		int done = 0;
		for (final Map.Entry<String, JFreeChart> chart : charts.entrySet()) {
			progress.report("Drawing figures", done++ / (double) charts.size());
			progress.checkCancelled();
			final boolean square = chart.getKey().equals(CONTOURS);
			final int width = square ? SQUARE_WIDTH : WIDTH;
			final int height = square ? SQUARE_HEIGHT : HEIGHT;
			files.addAll(write(folder, chart.getKey(), chart.getValue(), width, height));
		}
		progress.report("Drawing figures", 1);
		return files;
	}

	/** Writes one chart as PNG and SVG, of the usual size. */
	static List<Path> write(final Path folder, final String name, final JFreeChart chart)
		throws IOException {
		return write(folder, name, chart, WIDTH, HEIGHT);
	}

	private static List<Path> write(final Path folder, final String name, final JFreeChart chart,
		final int width, final int height) throws IOException {
		final Path png = folder.resolve(name + ".png"), svg = folder.resolve(name + ".svg");
		Files.write(png, png(chart, width, height));
		SvgChart.write(svg, chart, width, height);
		return List.of(png, svg);
	}

	/**
	 * Writes {@code tangent_angle_kymograph.tif} and
	 * {@code curvature_kymograph.tif}.
	 *
	 * @param folder an existing folder
	 * @param m the measurements
	 * @return the two files
	 * @throws IOException if the disk says no
	 */
	public static List<Path> writeKymographs(final Path folder, final MovieMeasurements m)
		throws IOException {
		final Path angle = folder.resolve("tangent_angle_kymograph.tif");
		final Path curvature = folder.resolve("curvature_kymograph.tif");
		writeTiff(angle, tangentAngleImage(m));
		writeTiff(curvature, curvatureImage(m));
		return List.of(angle, curvature);
	}

	/**
	 * @param m the measurements
	 * @return the tangent angle in rad, as a calibrated 32-bit image
	 */
	public static ImagePlus tangentAngleImage(final MovieMeasurements m) {
		return KymographImage.rising(m.name() + "-tangent-angle", m.tangentAngleKymograph(),
			m.calibration(), "rad");
	}

	/**
	 * @param m the measurements
	 * @return the curvature in 1/unit of length, as a calibrated 32-bit image
	 */
	public static ImagePlus curvatureImage(final MovieMeasurements m) {
		return KymographImage.twoSided(m.name() + "-curvature", m.curvatureKymograph(),
			m.calibration(), "1/" + m.calibration().unit());
	}

	private static void writeTiff(final Path file, final ImagePlus image) throws IOException {
		Files.write(file, new FileSaver(image).serialize());
	}

	private static byte[] png(final JFreeChart chart, final int width, final int height)
		throws IOException {
		final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
		ChartUtils.writeScaledChartAsPNG(bytes, chart, width, height, PNG_SCALE, PNG_SCALE);
		return bytes.toByteArray();
	}
}
