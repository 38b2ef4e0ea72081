package io.github.knotresolver.imagej;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;

import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;

/**
 * Paints frames of a result with the contours of some of its filaments. The only
 * filament is coloured along its length; of several each has a colour of its own.
 * The clamped end has a ring.
 */
final class ContourPainter {

	private final Tracks tracks;
	private final List<FilamentTrack> filaments;
	private final FramePainter painter;
	private final double line;
	private final double ring;

	/**
	 * @param tracks a result
	 * @param filaments those to be drawn
	 * @param painter paints frames
	 * @param line width of a contour on the screen
	 * @param ring radius of a ring on the screen
	 */
	ContourPainter(final Tracks tracks, final List<FilamentTrack> filaments,
		final FramePainter painter, final double line, final double ring) {
		this.tracks = tracks;
		this.filaments = filaments;
		this.painter = painter;
		this.line = line;
		this.ring = ring;
	}

	/**
	 * @param index of a frame, from 0
	 * @return the frame with its contours
	 */
	BufferedImage paint(final int index) {
		final BufferedImage picture = painter.paint(tracks.movie().frame(index));
		for (final FilamentTrack filament : filaments)
			filament.frames().get(index).contour().ifPresent(c -> {
				painter.draw(picture, c, colour(tracks, filament), line, 1);
				if (isHeld(filament))
					painter.mark(picture, c.first(), ring);
			});
		return picture;
	}

	/**
	 * @param picture gets the contours of all frames
	 * @param opacity of a contour, 0..1
	 */
	void drawAll(final BufferedImage picture, final double opacity) {
		for (final FilamentTrack filament : filaments) {
			for (final Observation frame : filament.frames())
				frame.contour().ifPresent(
					c -> painter.draw(picture, c, colour(tracks, filament), line, opacity));
			filament.fixedEnd().ifPresent(end -> painter.mark(picture, end, ring));
		}
	}

	private static boolean isHeld(final FilamentTrack filament) {
		return switch (filament.anchor()) {
			case CLAMPED -> true;
			case FREE -> false;
		};
	}

	/**
	 * @param tracks a result
	 * @param filament one of its filaments
	 * @return the filament's colour at a place along it, 0..1
	 */
	static DoubleFunction<Color> colour(final Tracks tracks, final FilamentTrack filament) {
		return tracks.filaments().size() == 1
			? Palette::along
			: fraction -> Palette.along(filament.id(), fraction);
	}

	/**
	 * @param tracks a result
	 * @param index of a frame, from 0
	 * @return the frame's status: {@code resolved} or, with several filaments,
	 *         {@code 1 resolved, 2 lost}
	 */
	static String label(final Tracks tracks, final int index) {
		if (tracks.filaments().size() == 1)
			return tracks.filaments().get(0).frames().get(index).status().label();
		return tracks.filaments().stream()
			.map(f -> f.id() + " " + f.frames().get(index).status().label())
			.collect(Collectors.joining(", "));
	}
}
