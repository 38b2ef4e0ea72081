package io.github.knotresolver.imagej;

import java.util.List;

import ij.measure.ResultsTable;
import io.github.knotresolver.geometry.Calibration;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.MeasuredFrame;
import io.github.knotresolver.io.MeasuredResolution;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.track.TrackedFrame;

/**
 * A result as ImageJ's tables {@code <image>-contours} and
 * {@code <image>-frames}, with units in the headings.
 */
public final class ContourTables {

	private final String image;
	private final List<MeasuredFrame> frames;
	private final Calibration calibration;

	/**
	 * @param image the image's title; tables are named after it
	 * @param result a measured result
	 */
	public ContourTables(final String image, final MeasuredResolution result) {
		this.image = image;
		this.frames = result.frames();
		this.calibration = result.calibration();
	}

	/** @return one row a point */
	public ResultsTable contours() {
		final ResultsTable table = new ResultsTable();
		table.setNaNEmptyCells(true);
		for (final MeasuredFrame frame : frames)
			frame.tracked().contour().ifPresent(contour -> addContour(table, frame, contour));
		return table;
	}

	private void addContour(final ResultsTable table, final MeasuredFrame frame,
		final Polyline contour) {
		final String length = unit(calibration.unit());
		final double[] arc = frame.arcLength();
		final double[] angle = frame.tangentAngle();
		final double[] curvature = frame.curvature();
		for (int i = 0; i < contour.size(); i++) {
			table.addRow();
			table.addValue("frame", frame.tracked().frame());
			table.addValue("index", i);
			table.addValue("x" + unit("px"), contour.x(i));
			table.addValue("y" + unit("px"), contour.y(i));
			table.addValue("x" + length, contour.x(i) * calibration.pixelSize());
			table.addValue("y" + length, contour.y(i) * calibration.pixelSize());
			table.addValue("arc length" + length, i < arc.length ? arc[i] : Double.NaN);
			table.addValue("tangent angle" + unit("rad"), i < angle.length ? angle[i] : Double.NaN);
			table.addValue("curvature" + unit("1/" + calibration.unit()),
				i < curvature.length ? curvature[i] : Double.NaN);
		}
	}

	/** @return one row for every frame */
	public ResultsTable frames() {
		final ResultsTable table = new ResultsTable();
		table.setNaNEmptyCells(true);
		final String length = unit(calibration.unit());
		for (final MeasuredFrame frame : frames) {
			final TrackedFrame tracked = frame.tracked();
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
			table.addValue("confidence", tracked.confidence());
			table.addValue("reason", tracked.reason());
		}
		return table;
	}

	/** Shows both tables under their names. */
	public void show() {
		contours().show(image + "-contours");
		frames().show(image + "-frames");
	}

	private static String unit(final String unit) {
		return " [" + unit + "]";
	}
}
