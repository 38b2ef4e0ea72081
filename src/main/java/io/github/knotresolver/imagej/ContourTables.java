package io.github.knotresolver.imagej;

import java.awt.GraphicsEnvironment;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.IntToDoubleFunction;

import ij.measure.ResultsTable;
import ij.plugin.filter.Analyzer;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.FilamentSummary;
import io.github.knotresolver.measure.Gliding;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.measure.MeasuredFrame;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Observation;

/**
 * A result as ImageJ's tables {@code <image>-contours},
 * {@code <image>-frames} and {@code <image>-filaments}, with units in the headings.
 */
public final class ContourTables {

	private static final String CONFIDENCE = "confidence", FILAMENT = "filament";

	private static final int PLACE_DECIMALS = 3, CURVATURE_DECIMALS = 5;

	/** The values of a frame's points; fewer, or none, if they were not measured. */
	@FunctionalInterface
	private interface Values {

		double[] of(MeasuredFrame frame, Polyline contour);
	}

	private final String image;
	private final MeasuredTracks result;
	private final List<MeasuredFrame> frames;
	private final Calibration calibration;

	/**
	 * @param image the image's title; tables are named after it
	 * @param result a measured result
	 */
	public ContourTables(final String image, final MeasuredTracks result) {
		this.image = image;
		this.result = result;
		this.frames = result.frames();
		this.calibration = result.calibration();
	}

	/** @return one row a point */
	public ResultsTable contours() {
		return points().table();
	}

	private PointTable points() {
		final String length = unit(calibration.unit());
		final double size = calibration.pixelSize();
		return new PointTable(List.of(
			column("frame", 0, (frame, contour) -> points(contour, i -> frame.tracked().frame())),
			column("index", 0, (frame, contour) -> points(contour, i -> i)),
			place("x" + unit("px"), (frame, contour) -> contour.xs()),
			place("y" + unit("px"), (frame, contour) -> contour.ys()),
			place("x" + length, (frame, contour) -> frame.x(size)),
			place("y" + length, (frame, contour) -> frame.y(size)),
			place("arc length" + length, (frame, contour) -> frame.arcLength()),
			place("tangent angle" + unit("rad"), (frame, contour) -> frame.tangentAngle()),
			column("curvature" + unit("1/" + calibration.unit()), CURVATURE_DECIMALS,
				(frame, contour) -> frame.curvature()),
			column(FILAMENT, 0, (frame, contour) -> points(contour, i -> frame.filament()))));
	}

	private PointTable.Column place(final String heading, final Values values) {
		return column(heading, PLACE_DECIMALS, values);
	}

	/** Not all contours can be measured; what is missing is no number. */
	private PointTable.Column column(final String heading, final int decimals,
		final Values values) {
		final int rows = frames.stream().flatMap(f -> f.tracked().contour().stream())
			.mapToInt(Polyline::size).sum();
		final double[] all = new double[rows];
		Arrays.fill(all, Double.NaN);
		int row = 0;
		for (final MeasuredFrame frame : frames) {
			final Polyline contour = frame.tracked().contour().orElse(null);
			if (contour == null)
				continue;
			final double[] own = values.of(frame, contour);
			System.arraycopy(own, 0, all, row, own.length);
			row += contour.size();
		}
		return new PointTable.Column(heading, decimals, all);
	}

	private static double[] points(final Polyline contour, final IntToDoubleFunction value) {
		final double[] values = new double[contour.size()];
		Arrays.setAll(values, value);
		return values;
	}

	/** @return one row for every filament and frame */
	public ResultsTable frames() {
		final ResultsTable table = new ResultsTable();
		table.setNaNEmptyCells(true);
		final String length = unit(calibration.unit());
		for (final MeasuredFrame frame : frames) {
			final Observation tracked = frame.tracked();
			table.addRow();
			table.addValue("frame", tracked.frame());
			table.addValue("time" + unit(calibration.timeUnit()),
				(tracked.frame() - 1) * calibration.frameInterval());
			table.addValue("status", tracked.status().label());
			table.addValue("length" + length, frame.length());
			table.addValue("end-to-end distance" + length, frame.get(Quantity.END_TO_END));
			table.addValue("tip angle" + unit("rad"), frame.get(Quantity.TIP_ANGLE));
			table.addValue("junctions", tracked.junctions());
			table.addValue("crossings", tracked.crossings());
			table.addValue("candidates", tracked.candidates());
			table.addValue("cost", tracked.cost());
			table.addValue(CONFIDENCE, tracked.confidence());
			table.addValue(FILAMENT, frame.filament());
			table.addValue("reason", tracked.reason());
		}
		return table;
	}

	/** @return one row for every filament */
	public ResultsTable filaments() {
		final ResultsTable table = new ResultsTable();
		table.setNaNEmptyCells(true);
		final String length = unit(calibration.unit());
		for (final MeasuredFilament filament : result.filaments()) {
			final FilamentSummary s = FilamentSummary.of(filament, calibration);
			table.addRow();
			table.addValue(FILAMENT, filament.track().id());
			table.addValue("anchor", filament.track().anchor().label());
			table.addValue("first frame", orNaN(s.firstFrame()));
			table.addValue("last frame", orNaN(s.lastFrame()));
			table.addValue("length" + length, s.length());
			table.addValue("length SE" + length, s.lengthError());
			table.addValue("frames resolved", filament.track().resolved());
			table.addValue("mean confidence", s.confidence());
			table.addValue("gliding path" + length,
				s.gliding().map(Gliding::path).orElse(Double.NaN));
			table.addValue(
				"gliding speed" + unit(calibration.unit() + "/" + calibration.timeUnit()),
				s.gliding().map(Gliding::speed).orElse(Double.NaN));
		}
		return table;
	}

	private static double orNaN(final OptionalInt frame) {
		return frame.isPresent() ? frame.getAsInt() : Double.NaN;
	}

	/**
	 * Shows the tables under their names. Without a display, where ImageJ has
	 * no table but its Results, the frames become these, so that macros can read
	 * them ({@code nResults}, {@code getResult}); rows of others are kept instead.
	 *
	 * @return whether the tables are there
	 */
	public boolean show() {
		if (GraphicsEnvironment.isHeadless())
			return showAsResults();
		points().show(image + "-contours");
		frames().show(image + "-frames");
		filaments().show(image + "-filaments");
		return true;
	}

	private boolean showAsResults() {
		final ResultsTable present = ResultsTable.getResultsTable();
		if (present.size() > 0 && !present.columnExists(CONFIDENCE))
			return false;
		Analyzer.setResultsTable(frames());
		return true;
	}

	private static String unit(final String unit) {
		return " [" + unit + "]";
	}
}
