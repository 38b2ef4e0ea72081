package io.github.knotresolver.imagej;

import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

import ij.ImagePlus;
import ij.gui.PointRoi;
import ij.gui.PolygonRoi;
import ij.gui.Roi;
import ij.io.RoiEncoder;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;

/**
 * Contours to ROIs and back. In ImageJ's line and point selections an integer is
 * the centre of a pixel (see {@link Roi#useLineSubpixelConvention()}), as it is in
 * contours, so coordinates are the same on both sides. Only area selections count
 * from the corner of the first pixel.
 */
public final class RoiConverter {

	/** The file of a set in a result folder. */
	public static final String SET_FILE = "RoiSet.zip";

	/** The first moment that a zip file knows. */
	private static final LocalDateTime NO_TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

	/** Every name starts so. */
	static final String PREFIX = "knot-";

	private static final int LEAST_DIGITS = 4;
	/** ImageJ keeps a group in one byte. */
	private static final int MOST_GROUPS = 255;

	/** Where ROIs of a frame stand. */
	private interface Place {

		void set(Roi roi, int frame);
	}

	private final Place place;
	private final int digits;

	private RoiConverter(final int frames, final Place place) {
		this.place = place;
		this.digits = Math.max(LEAST_DIGITS, Integer.toString(frames).length());
	}

	/**
	 * @param frames number of frames of the movie
	 * @return a converter that sets positions of a stack: frame n is slice n
	 */
	public static RoiConverter forStack(final int frames) {
		return new RoiConverter(frames, (roi, frame) -> roi.setPosition(frame));
	}

	/**
	 * @param image where the ROIs will be shown; it may be closed later
	 * @param channel the 1-based channel that was resolved
	 * @return a converter that sets the positions of this image
	 */
	public static RoiConverter forImage(final ImagePlus image, final int channel) {
		if (image.getNChannels() == 1)
			return forStack(image.getStackSize());
		if (ImageMovie.isAlongChannels(image))
			return new RoiConverter(image.getNChannels(),
				(roi, frame) -> roi.setPosition(frame, 1, 1));
		if (ImageMovie.isAlongZ(image))
			return new RoiConverter(image.getNSlices(),
				(roi, frame) -> roi.setPosition(channel, frame, 1));
		return new RoiConverter(image.getNFrames(),
			(roi, frame) -> roi.setPosition(channel, 1, frame));
	}

	/**
	 * @param tracks a result
	 * @return one sub-pixel polyline for every filament and frame that has a contour,
	 *         filament by filament, with name and position; with several filaments, their
	 *         number is in the name, and is the group
	 */
	public List<Roi> rois(final Tracks tracks) {
		final List<Roi> rois = new ArrayList<>();
		for (final FilamentTrack filament : tracks.filaments())
			for (final Observation frame : filament.frames())
				frame.contour().ifPresent(c -> rois.add(
					roi(c, frame.frame(), tracks.filaments().size() == 1 ? 0 : filament.id())));
		return rois;
	}

	/**
	 * @param contour a contour in pixels
	 * @param frame its 1-based frame
	 * @param filament its filament's number if there are several; 0 for the only one
	 * @return a sub-pixel polyline with name and position
	 */
	Roi roi(final Polyline contour, final int frame, final int filament) {
		final String number = String.format(Locale.ROOT, "%0" + digits + "d", frame);
		final PolygonRoi line = polyline(contour);
		final Roi roi = filament == 0
			? line
			: new GroupedLine(line, (filament - 1) % MOST_GROUPS + 1);
		if (filament == 0)
			roi.setName(PREFIX + number);
		else {
			roi.setName(PREFIX + MeasuredFilament.number(filament) + "-" + number);
			roi.setStrokeColor(Palette.ofFilament(filament));
		}
		place.set(roi, frame);
		return roi;
	}

	/**
	 * @param shape any ROI; its position is changed
	 * @param frame a 1-based frame
	 * @return the same, at the position of that frame
	 */
	public Roi placed(final Roi shape, final int frame) {
		place.set(shape, frame);
		return shape;
	}

	/**
	 * @param contour a contour in pixels
	 * @return a sub-pixel polyline without name and position
	 */
	public static PolygonRoi polyline(final Polyline contour) {
		final float[] x = new float[contour.size()], y = new float[contour.size()];
		for (int i = 0; i < x.length; i++) {
			x[i] = (float) contour.x(i);
			y[i] = (float) contour.y(i);
		}
		return new PolygonRoi(x, y, Roi.POLYLINE);
	}

	/**
	 * @param roi a selection; may be null
	 * @return the first point of a point selection, in pixels; empty if it is
	 *         another kind
	 */
	public static Optional<Point> point(final Roi roi) {
		if (!(roi instanceof PointRoi))
			return Optional.empty();
		final var points = roi.getFloatPolygon();
		return Optional.of(new Point(points.xpoints[0], points.ypoints[0]));
	}

	/**
	 * @param roi a selection; may be null
	 * @return the course of a line selection, in pixels; empty if it is another kind
	 */
	public static Optional<Polyline> line(final Roi roi) {
		if (roi == null || !roi.isLine())
			return Optional.empty();
		final var points = roi.getFloatPolygon();
		final double[] x = new double[points.npoints], y = new double[points.npoints];
		for (int i = 0; i < x.length; i++) {
			x[i] = points.xpoints[i];
			y[i] = points.ypoints[i];
		}
		return Optional.of(Polyline.of(x, y));
	}

	/**
	 * @param image an image
	 * @return the bounds of its area selection; empty if it has none, or all is
	 *         selected
	 * @throws UserException if it is too small, in one sentence
	 */
	public static Optional<Region> region(final ImagePlus image) {
		final Roi roi = image.getRoi();
		if (roi == null || !roi.isArea())
			return Optional.empty();
		final Rectangle all = new Rectangle(image.getWidth(), image.getHeight());
		final Rectangle part = roi.getBounds().intersection(all);
		return part.equals(all)
			? Optional.empty()
			: Optional
				.of(new Region(part.x, part.y, Math.max(0, part.width), Math.max(0, part.height)));
	}

	/**
	 * Writes a zip file as ImageJ's ROI Manager reads and writes it. The same ROIs
	 * give the same bytes.
	 *
	 * @param file the file to write
	 * @param rois ROIs with different names
	 * @throws IOException if a file cannot be written
	 */
	public static void writeSet(final Path file, final List<Roi> rois) throws IOException {
		try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
			for (final Roi roi : rois) {
				final ZipEntry entry = new ZipEntry(roi.getName() + ".roi");
				entry.setTimeLocal(NO_TIME);
				zip.putNextEntry(entry);
				zip.write(RoiEncoder.saveAsByteArray(roi));
				zip.closeEntry();
			}
		}
	}

	/**
	 * A polyline with a group. ImageJ looks for a colour table in its folder when a
	 * group is set, and complains in the log where there is none; this one has a
	 * colour of its own.
	 */
	private static final class GroupedLine extends PolygonRoi {

		private int group;

		/**
		 * @param line a sub-pixel polyline
		 * @param group 1 to 255
		 */
		GroupedLine(final PolygonRoi line, final int group) {
			super(line.getFloatPolygon().xpoints, line.getFloatPolygon().ypoints, POLYLINE);
			this.group = group;
		}

		@Override
		public int getGroup() {
			return group;
		}

		@Override
		public void setGroup(final int other) {
			group = other;
			super.setGroup(other);
		}
	}
}
