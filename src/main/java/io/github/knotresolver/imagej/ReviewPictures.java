package io.github.knotresolver.imagej;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;

import ij.gui.Overlay;
import ij.gui.PolygonRoi;
import ij.gui.Roi;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Contrast;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Tracks;

/** What a review shows of a frame: small pictures of it, and contours over the image. */
public final class ReviewPictures {

	private static final int BRIGHTEST = 170, PIECES = 24, LINKS = 6;
	private static final double LINE = 2, RING = 4;
	private static final float[] DASHES = {4, 3};

	private final Movie movie;
	private final Contrast contrast;

	/** @param movie the movie under review */
	public ReviewPictures(final Movie movie) {
		this.movie = movie;
		contrast = Contrast.of(movie, BRIGHTEST);
	}

	/**
	 * How large small pictures are.
	 *
	 * @param width at most, in units of the window
	 * @param height likewise
	 * @param sharpness pixels of the screen for one such unit
	 */
	public record Size(int width, int height, double sharpness) {
	}

	/** Small pictures of one part of the movie, all of one size. */
	public final class Small {

		private final DoubleFunction<Color> colour;
		private final FramePainter painter;
		private final double sharpness;

		private Small(final DoubleFunction<Color> colour, final Viewport part, final Size size) {
			this.colour = colour;
			sharpness = size.sharpness;
			painter = new FramePainter(contrast, part.scaled(sharpness * Math
				.min(size.width / (double) part.width(), size.height / (double) part.height())));
		}

		/**
		 * @param frame from 1
		 * @param contour what is drawn; empty for the picture alone
		 * @return the part of the frame, with the contour, in pixels of the screen
		 */
		public BufferedImage paint(final int frame, final Optional<Polyline> contour) {
			final BufferedImage picture = painter.paint(movie.frame(frame - 1));
			contour.ifPresent(c -> {
				painter.draw(picture, c, colour, LINE * sharpness, 1);
				painter.mark(picture, c.first(), RING * sharpness);
			});
			return picture;
		}
	}

	/**
	 * @param tracks the result
	 * @param track the filament under review
	 * @param shown contours that are to be seen
	 * @param size of the pictures
	 * @return what paints the part of the movie around these contours, of the same shape for all frames
	 */
	public Small small(final Tracks tracks, final FilamentTrack track, final List<Polyline> shown,
		final Size size) {
		return new Small(ContourPainter.colour(tracks, track),
			Viewport.aroundContours(movie, List.of(track)).closeUp(movie, shown), size);
	}

	/**
	 * @param tracks the result
	 * @param track one of its filaments
	 * @param contour in pixels
	 * @return shapes without a position: the contour, coloured along its length
	 */
	public static Overlay overlay(final Tracks tracks, final FilamentTrack track,
		final Polyline contour) {
		final Overlay overlay = new Overlay();
		final Polyline line = contour.divided(PIECES * LINKS);
		for (int i = 0; i < PIECES; i++) {
			final Roi piece = RoiConverter
				.polyline(Polyline.of(Arrays.copyOfRange(line.xs(), i * LINKS, (i + 1) * LINKS + 1),
					Arrays.copyOfRange(line.ys(), i * LINKS, (i + 1) * LINKS + 1)));
			piece.setStrokeColor(ContourPainter.colour(tracks, track).apply((i + 0.5) / PIECES));
			piece.setUnscalableStrokeWidth(LINE);
			overlay.add(piece);
		}
		return overlay;
	}

	/**
	 * @param tracks the result
	 * @param track the filament under review
	 * @param frame from 1
	 * @return thin lines without a position: the other filaments in their colours
	 */
	public static List<Roi> others(final Tracks tracks, final FilamentTrack track,
		final int frame) {
		final List<Roi> lines = new ArrayList<>();
		for (final FilamentTrack other : tracks.filaments())
			if (other.id() != track.id())
				other.frames().get(frame - 1).contour().ifPresent(c -> {
					final Roi line = RoiConverter.polyline(c);
					line.setStrokeColor(ContourPainter.colour(tracks, other).apply(0.5));
					line.setUnscalableStrokeWidth(1);
					lines.add(line);
				});
		return lines;
	}

	/**
	 * @param contour in pixels
	 * @return a dashed white line: what might be, or is being drawn
	 */
	public static Roi dashed(final Polyline contour) {
		final PolygonRoi roi = RoiConverter.polyline(contour);
		roi.setStroke(
			new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, DASHES, 0));
		roi.setStrokeColor(Color.WHITE);
		return roi;
	}

	/**
	 * @param confidence 0..1
	 * @return its colour, told apart by people with any colour vision
	 */
	public static Color colour(final double confidence) {
		return Palette.ofConfidence(confidence);
	}
}
