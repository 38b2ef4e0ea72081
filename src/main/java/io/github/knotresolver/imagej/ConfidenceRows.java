package io.github.knotresolver.imagej;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.List;

import io.github.knotresolver.io.ResultDigest;
import io.github.knotresolver.model.FrameStatus;

/**
 * How sure a result is, as a picture: a column a frame, a row a filament, in the colours that the
 * review window has. Of long movies several frames share a column, which shows the least sure of them.
 */
final class ConfidenceRows {

	/** Most columns and rows. */
	static final int MOST_COLUMNS = 600, MOST_ROWS = 64;

	/** What needs a look first. */
	private static final Comparator<ResultDigest.Frame> WORST_FIRST = Comparator
		.comparingInt((ResultDigest.Frame f) -> switch (f.status()) {
			case UNRESOLVED -> 0;
			case LOST -> 1;
			case RESOLVED, CORRECTED -> 2;
			case IGNORED, ABSENT -> 3;
		}).thenComparingDouble(ResultDigest.Frame::confidence);

	private ConfidenceRows() {
	}

	/**
	 * @param result a result with at least one frame
	 * @return the picture, a pixel a frame and filament
	 */
	static BufferedImage of(final ResultDigest result) {
		final int columns = Math.min(MOST_COLUMNS, result.frames());
		final int rows = Math.min(MOST_ROWS, result.filaments().size());
		final BufferedImage strip = new BufferedImage(columns, rows, BufferedImage.TYPE_INT_RGB);
		for (int row = 0; row < rows; row++) {
			final List<ResultDigest.Frame> frames = result.filaments().get(row).frames();
			for (int x = 0; x < columns; x++)
				strip.setRGB(x, row, colour(frames, x, columns, result.frames()).getRGB());
		}
		return strip;
	}

	private static Color colour(final List<ResultDigest.Frame> frames, final int x,
		final int columns, final int count) {
		final int from = (int) ((long) x * count / columns),
			to = (int) ((long) (x + 1) * count / columns);
		return frames.subList(Math.min(from, frames.size()), Math.min(to, frames.size())).stream()
			.min(WORST_FIRST).map(ConfidenceRows::colour).orElse(Palette.of(FrameStatus.ABSENT));
	}

	private static Color colour(final ResultDigest.Frame frame) {
		return frame.status() == FrameStatus.RESOLVED
			? Palette.ofConfidence(frame.confidence())
			: Palette.of(frame.status());
	}
}
