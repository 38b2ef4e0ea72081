package io.github.knotresolver.imagej;

import java.awt.Color;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import ij.gui.Overlay;
import ij.gui.PointRoi;
import ij.gui.Roi;
import ij.plugin.filter.ThresholdToSelection;
import ij.process.ByteProcessor;
import ij.process.ImageProcessor;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.session.FrameLook;

/**
 * A look at a frame as shapes over the image: the outline of the mask as a thin white line, the
 * skeleton as dots, contours coloured along their length.
 */
public final class LookOverlay {

	/** Every name starts so. */
	private static final String PREFIX = "look-";
	private static final Color OUTLINE = Color.WHITE, DOTS = new Color(0x56, 0xb4, 0xe9);
	private static final int PIECES = 16, LINKS = 4, TINY = 0;
	private static final double LINE = 1.5;

	private LookOverlay() {
	}

	/**
	 * What is drawn.
	 *
	 * @param outline of the mask
	 * @param skeleton as dots
	 * @param contours as coloured lines
	 */
	public record Parts(boolean outline, boolean skeleton, boolean contours) {

		/** Everything. */
		public static final Parts ALL = new Parts(true, true, true);
	}

	/**
	 * @param look at a frame
	 * @param parts what is drawn of it
	 * @param places sets the position of that frame
	 * @param before the image's overlay, of which contours of earlier runs are left out; may be null
	 * @return the shapes
	 */
	public static Overlay of(final FrameLook look, final Parts parts, final RoiConverter places,
		final Overlay before) {
		final Overlay overlay = without(before);
		if (parts.outline)
			outline(look.mask()).ifPresent(r -> add(overlay, r, "mask", look, places));
		if (parts.skeleton)
			dots(look.skeleton()).ifPresent(r -> add(overlay, r, "skeleton", look, places));
		if (parts.contours)
			for (int i = 0; i < look.contours().size(); i++)
				for (final Roi piece : pieces(look.contours(), i))
					add(overlay, piece, "contour", look, places);
		return overlay;
	}

	/**
	 * Contours while they are being found: thin lines, each at its frame.
	 *
	 * @param sightings contours in pixels by 1-based frame
	 * @param places sets the positions of frames
	 * @param before the image's overlay, which is shown, too; may be null
	 * @return the shapes
	 */
	public static Overlay of(final SortedMap<Integer, List<Polyline>> sightings,
		final RoiConverter places, final Overlay before) {
		final Overlay overlay = without(before);
		sightings.forEach((frame, contours) -> {
			for (int i = 0; i < contours.size(); i++) {
				final Roi line = RoiConverter.polyline(contours.get(i));
				line.setStrokeColor(Palette.ofFilament(i + 1));
				line.setUnscalableStrokeWidth(1);
				line.setName(PREFIX + "sighted");
				overlay.add(places.placed(line, frame));
			}
		});
		return overlay;
	}

	/** What others have drawn; before may be null. */
	private static Overlay without(final Overlay before) {
		final Overlay overlay = new Overlay();
		if (before != null)
			Arrays.stream(before.toArray()).filter(r -> !isOurs(r)).forEach(overlay::add);
		return overlay;
	}

	private static boolean isOurs(final Roi roi) {
		return roi.getName() != null
			&& (roi.getName().startsWith(PREFIX) || roi.getName().startsWith(RoiConverter.PREFIX));
	}

	private static void add(final Overlay overlay, final Roi roi, final String name,
		final FrameLook look, final RoiConverter places) {
		roi.setName(PREFIX + name);
		overlay.add(places.placed(roi, look.frame()));
	}

	private static Optional<Roi> outline(final Img<BitType> mask) {
		final boolean[] bits = Pixels.bits(mask);
		final ByteProcessor pixels = new ByteProcessor(Pixels.width(mask), Pixels.height(mask));
		for (int i = 0; i < bits.length; i++)
			pixels.set(i, bits[i] ? 255 : 0);
		pixels.setThreshold(255, 255, ImageProcessor.NO_LUT_UPDATE);
		final Roi roi = new ThresholdToSelection().convert(pixels);
		if (roi == null)
			return Optional.empty();
		roi.setStrokeColor(OUTLINE);
		roi.setUnscalableStrokeWidth(1);
		return Optional.of(roi);
	}

	private static Optional<Roi> dots(final Img<BitType> skeleton) {
		final boolean[] bits = Pixels.bits(skeleton);
		final int width = Pixels.width(skeleton);
		int count = 0;
		for (final boolean bit : bits)
			count += bit ? 1 : 0;
		if (count == 0)
			return Optional.empty();
		final float[] x = new float[count], y = new float[count];
		int i = 0;
		for (int at = 0; at < bits.length; at++)
			if (bits[at]) {
				x[i] = at % width;
				y[i++] = at / width;
			}
		final PointRoi dots = new PointRoi(x, y);
		dots.setPointType(PointRoi.DOT);
		dots.setSize(TINY);
		dots.setShowLabels(false);
		dots.setStrokeColor(DOTS);
		return Optional.of(dots);
	}

	private static List<Roi> pieces(final List<Polyline> contours, final int index) {
		final Polyline line = contours.get(index).divided(PIECES * LINKS);
		final Roi[] pieces = new Roi[PIECES];
		for (int i = 0; i < PIECES; i++) {
			pieces[i] = RoiConverter
				.polyline(Polyline.of(Arrays.copyOfRange(line.xs(), i * LINKS, (i + 1) * LINKS + 1),
					Arrays.copyOfRange(line.ys(), i * LINKS, (i + 1) * LINKS + 1)));
			final double along = (i + 0.5) / PIECES;
			pieces[i].setStrokeColor(
				contours.size() == 1 ? Palette.along(along) : Palette.along(index + 1, along));
			pieces[i].setUnscalableStrokeWidth(LINE);
		}
		return List.of(pieces);
	}
}
