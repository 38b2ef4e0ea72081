package io.github.knotresolver.imagej.plot;

import java.awt.Dimension;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

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
	static final int WIDTH = 450, HEIGHT = 300;
	private static final int SQUARE_WIDTH = 440, SQUARE_HEIGHT = 380;
	/** PNG pixels for each point of a chart: 1800 pixels for a page's width. */
	private static final int PNG_SCALE = 4;
	private static final String CONTOURS = "contours", TANGENT_ANGLE = "tangent_angle_kymograph",
		CURVATURE = "curvature_kymograph";

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
		suppliers(m)
			.forEach((name, chart) -> chart.get().ifPresent(present -> charts.put(name, present)));
		return charts;
	}

	private static Map<String, Supplier<Optional<JFreeChart>>> suppliers(
		final MovieMeasurements m) {
		final Map<String, Supplier<Optional<JFreeChart>>> charts = new LinkedHashMap<>();
		charts.put(CONTOURS, () -> Optional.of(ContoursChart.of(m)));
		charts.put(TANGENT_ANGLE, () -> Optional.of(KymographChart.tangentAngle(m)));
		charts.put(CURVATURE, () -> Optional.of(KymographChart.curvature(m)));
		for (final Quantity q : List.of(Quantity.END_TO_END, Quantity.LENGTH, Quantity.TIP_ANGLE))
			charts.put(q.key(), () -> Optional.of(SeriesChart.of(m, q)));
		for (final Quantity q : m.spectra())
			charts.put(q.key() + "_spectrum", () -> SpectrumChart.of(m, q));
		return charts;
	}

	/**
	 * Writes every chart as PNG and SVG, and the kymographs as calibrated 32-bit
	 * TIFF. Works without a display.
	 *
	 * @param pictures draws them
	 * @param suffix what the files' names have before their ending; may be empty
	 * @param m the measurements
	 * @param progress told how far it is; may cancel
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Pictures pictures, final String suffix,
		final MovieMeasurements m, final Progress progress) throws IOException {
		writeKymographs(pictures, suffix, m);
		final Map<String, Supplier<Optional<JFreeChart>>> charts = suppliers(m);
		int done = 0;
		for (final Map.Entry<String, Supplier<Optional<JFreeChart>>> chart : charts.entrySet()) {
			progress.report("Drawing figures", done++ / (double) charts.size());
			progress.checkCancelled();
			final boolean square = chart.getKey().equals(CONTOURS);
			write(pictures, chart.getKey() + suffix, chart.getValue(),
				square ? new Dimension(SQUARE_WIDTH, SQUARE_HEIGHT) : new Dimension(WIDTH, HEIGHT));
		}
		progress.report("Drawing figures", 1);
	}

	/** Writes one chart as PNG and SVG, of the usual size. */
	static void write(final Pictures pictures, final String name, final JFreeChart chart)
		throws IOException {
		write(pictures, name, () -> Optional.of(chart), new Dimension(WIDTH, HEIGHT));
	}

	private static void write(final Pictures pictures, final String name,
		final Supplier<Optional<JFreeChart>> supplier, final Dimension size) throws IOException {
		pictures.draw(name + ".png", png -> {
			final Optional<JFreeChart> chart = supplier.get();
			if (chart.isEmpty())
				return;
			Files.write(png, png(chart.get(), size.width, size.height));
			pictures.draw(name + ".svg",
				svg -> SvgChart.write(svg, chart.get(), size.width, size.height));
		});
	}

	/**
	 * Writes {@code tangent_angle_kymograph.tif} and
	 * {@code curvature_kymograph.tif}.
	 *
	 * @param pictures draws them
	 * @param suffix what the files' names have before their ending; may be empty
	 * @param m the measurements
	 * @throws IOException if a file cannot be written
	 */
	public static void writeKymographs(final Pictures pictures, final String suffix,
		final MovieMeasurements m) throws IOException {
		pictures.draw(TANGENT_ANGLE + suffix + ".tif",
			file -> writeTiff(file, tangentAngleImage(m)));
		pictures.draw(CURVATURE + suffix + ".tif", file -> writeTiff(file, curvatureImage(m)));
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

	static byte[] png(final JFreeChart chart, final int width, final int height)
		throws IOException {
		final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
		ChartUtils.writeScaledChartAsPNG(bytes, chart, width, height, PNG_SCALE, PNG_SCALE);
		return bytes.toByteArray();
	}
}
