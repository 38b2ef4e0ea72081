package io.github.knotresolver.imagej;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import ij.ImagePlus;
import ij.gui.Roi;
import ij.plugin.frame.RoiManager;
import ij.process.FloatPolygon;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;

/** The polylines of the ROI Manager as contours, each of the frame it stands on. */
public final class RoiContours {

	private static final Pattern SEVERAL = Pattern.compile(RoiConverter.PREFIX + "(\\d{1,6})-\\d+");

	private RoiContours() {
	}

	/**
	 * @param manager the ROI Manager; may be null
	 * @param image where the polylines belong: gives name, calibration and the
	 *          number of frames; may be null
	 * @return the contours of every filament, at least one
	 * @throws UserException if there are none, or two on one frame; in
	 *           one sentence
	 */
	public static List<ContourInput> read(final RoiManager manager, final ImagePlus image) {
		final SortedMap<Integer, TreeMap<Integer, Polyline>> filaments = new TreeMap<>();
		for (final Roi roi : manager == null ? new Roi[0] : manager.getRoisAsArray())
			if (isLine(roi))
				add(filaments.computeIfAbsent(filament(roi), k -> new TreeMap<>()), roi,
					frame(roi, image));
		if (filaments.isEmpty())
			throw new UserException(
				"There is no polyline in the ROI Manager; resolve a movie first, or name a result with result=FOLDER.");
		final String name = image == null ? "contours" : image.getTitle();
		final Calibration units = image == null ? Calibration.NONE : ImageCalibration.of(image);
		final List<ContourInput> all = new ArrayList<>();
		filaments.forEach((number,
			contours) -> all.add(new ContourInput(
				filaments.size() == 1 ? name : name + "-" + MeasuredFilament.number(number),
				all(contours, image), units, 0, number)));
		return all;
	}

	private static List<Optional<Polyline>> all(final TreeMap<Integer, Polyline> contours,
		final ImagePlus image) {
		final int frames = Math.max(contours.lastKey(), image == null ? 0 : frames(image));
		final List<Optional<Polyline>> all = new ArrayList<>();
		for (int frame = 1; frame <= frames; frame++)
			all.add(Optional.ofNullable(contours.get(frame)));
		return all;
	}

	/** ROIs of several filaments have two numbers in their names. */
	static int filament(final Roi roi) {
		final Matcher name = SEVERAL.matcher(roi.getName() == null ? "" : roi.getName());
		return name.matches() ? Integer.parseInt(name.group(1)) : 1;
	}

	static boolean isLine(final Roi roi) {
		return roi.getType() == Roi.POLYLINE || roi.getType() == Roi.FREELINE;
	}

	/** In an image whose slices stand for time, the frame is the slice. */
	static int frame(final Roi roi, final ImagePlus image) {
		final boolean slices = image != null && image.getNFrames() == 1;
		final int told = slices ? roi.getZPosition() : roi.getTPosition();
		if (told > 0 || roi.getPosition() < 1 || image == null || image.getNChannels() == 1)
			return Math.max(told, roi.getPosition());
		final int[] place = image.convertIndexToPosition(roi.getPosition());
		return slices ? place[1] : place[2];
	}

	private static void add(final TreeMap<Integer, Polyline> contours, final Roi roi,
		final int frame) {
		if (frame < 1)
			throw new UserException("The ROI '" + roi.getName()
				+ "' stands on no frame; set one with More > Properties in the ROI Manager.");
		if (contours.put(frame, contour(roi)) != null)
			throw new UserException("The ROI Manager has two polylines on frame " + frame
				+ "; delete one, the second is '" + roi.getName() + "'.");
	}

	static Polyline contour(final Roi roi) {
		final FloatPolygon points = roi.getFloatPolygon();
		final double[] x = new double[points.npoints], y = new double[points.npoints];
		Arrays.setAll(x, i -> points.xpoints[i]);
		Arrays.setAll(y, i -> points.ypoints[i]);
		return Polyline.of(x, y);
	}

	private static int frames(final ImagePlus image) {
		return image.getNFrames() > 1 ? image.getNFrames() : image.getNSlices();
	}
}
