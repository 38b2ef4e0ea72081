package io.github.knotresolver.imagej;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.function.DoubleFunction;

import net.imglib2.RandomAccess;
import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.RealType;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Contrast;

/** Paints frames in grey and contours in colour along their length. */
final class FramePainter {

	/** Steps of a colour along a contour, in pixels. */
	private static final double STEP = 1.5;

	/** The greys of whole numbers from 0 on are kept: those of all 16-bit pixels. */
	private static final int KEPT = 1 << 16, UNKNOWN = -1;

	private final Contrast contrast;
	private final Viewport view;
	private final int[] kept = new int[KEPT];

	FramePainter(final Contrast contrast, final Viewport view) {
		this.contrast = contrast;
		this.view = view;
		Arrays.fill(kept, UNKNOWN);
	}

	/**
	 * @param frame x, y
	 * @return the viewport's part of it, in grey; of type {@link BufferedImage#TYPE_INT_RGB}
	 */
	BufferedImage paint(final RandomAccessibleInterval<? extends RealType<?>> frame) {
		final BufferedImage part = new BufferedImage(view.width(), view.height(),
			BufferedImage.TYPE_INT_RGB);
		final RandomAccess<? extends RealType<?>> pixel = frame.randomAccess();
		final int[] row = new int[view.width()];
		for (int y = 0; y < view.height(); y++) {
			pixel.setPosition(view.x(), 0);
			pixel.setPosition(view.y() + y, 1);
			for (int x = 0; x < row.length; x++) {
				if (x > 0)
					pixel.fwd(0);
				row[x] = 0x010101 * gray(pixel.get().getRealDouble());
			}
			part.getRaster().setDataElements(0, y, row.length, 1, row);
		}
		return enlarged(part);
	}

	private int gray(final double value) {
		final int whole = (int) value;
		if (whole != value || whole < 0 || whole >= KEPT)
			return contrast.gray(value);
		if (kept[whole] == UNKNOWN)
			kept[whole] = contrast.gray(value);
		return kept[whole];
	}

	private BufferedImage enlarged(final BufferedImage part) {
		if (part.getWidth() == view.screenWidth() && part.getHeight() == view.screenHeight())
			return part;
		final BufferedImage picture = new BufferedImage(view.screenWidth(), view.screenHeight(),
			BufferedImage.TYPE_INT_RGB);
		final Graphics2D g = picture.createGraphics();
		g.setRenderingHint(RenderingHints.KEY_INTERPOLATION,
			view.scale() < 1
				? RenderingHints.VALUE_INTERPOLATION_BILINEAR
				: RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
		g.drawImage(part, 0, 0, picture.getWidth(), picture.getHeight(), null);
		g.dispose();
		return picture;
	}

	/**
	 * @param picture where to draw
	 * @param contour a contour in pixels
	 * @param colour of a place along it, 0..1
	 * @param width of the line on the screen
	 * @param opacity 0..1
	 */
	void draw(final BufferedImage picture, final Polyline contour,
		final DoubleFunction<Color> colour, final double width, final double opacity) {
		final Graphics2D g = smooth(picture);
		g.setComposite(AlphaComposite.getInstance(AlphaComposite.SRC_OVER, (float) opacity));
		final int cap = opacity < 1 ? BasicStroke.CAP_BUTT : BasicStroke.CAP_ROUND;
		g.setStroke(new BasicStroke((float) width, cap, BasicStroke.JOIN_ROUND));
		final Polyline line = contour.resampled(STEP);
		for (int i = 1; i < line.size(); i++) {
			g.setColor(colour.apply(i / (double) (line.size() - 1)));
			g.draw(new Line2D.Double(view.screenX(line.x(i - 1)), view.screenY(line.y(i - 1)),
				view.screenX(line.x(i)), view.screenY(line.y(i))));
		}
		g.dispose();
	}

	/**
	 * @param picture where to draw
	 * @param end the fixed end, marked by a ring
	 * @param radius of the ring on the screen
	 */
	void mark(final BufferedImage picture, final Point end, final double radius) {
		final Graphics2D g = smooth(picture);
		g.setColor(Palette.FIXED_END);
		g.setStroke(new BasicStroke((float) Math.max(1, radius / 3)));
		g.draw(new Ellipse2D.Double(view.screenX(end.x()) - radius, view.screenY(end.y()) - radius,
			2 * radius, 2 * radius));
		g.dispose();
	}

	private static Graphics2D smooth(final BufferedImage picture) {
		final Graphics2D g = picture.createGraphics();
		g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
		g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
		return g;
	}
}
