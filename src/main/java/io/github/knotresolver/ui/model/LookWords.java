package io.github.knotresolver.ui.model;

import java.util.List;
import java.util.Locale;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.session.FrameLook;

/** A look at a frame in words. */
final class LookWords {

	/** So many lengths are named. */
	private static final int MOST = 3;

	private LookWords() {
	}

	/** @return one line, such as {@code frame 17: 1 filament, width 4.2 px, bright on dark, 18.3 µm, ends clear} */
	static String line(final FrameLook look, final Calibration calibration) {
		final String frame = "frame " + look.frame() + ": ";
		if (look.contours().isEmpty())
			return frame + (look.objects() == 0
				? "nothing was found"
				: look.objects() + (look.objects() == 1 ? " object" : " objects")
					+ ", but no line");
		final int n = look.contours().size();
		final StringBuilder line = new StringBuilder(frame);
		line.append(n).append(n == 1 ? " filament, " : " filaments, ");
		look.width().ifPresent(w -> line.append(String.format(Locale.ROOT, "width %.1f px, ", w)));
		line.append(look.polarity() == Polarity.DARK ? "dark on bright, " : "bright on dark, ");
		return line.append(lengths(look.contours(), calibration)).append(", ").append(ends(look))
			.toString();
	}

	private static String lengths(final List<Polyline> contours, final Calibration calibration) {
		final StringBuilder lengths = new StringBuilder();
		for (int i = 0; i < Math.min(MOST, contours.size()); i++)
			lengths.append(i == 0 ? "" : " + ").append(String.format(Locale.ROOT, "%.1f",
				contours.get(i).length() * calibration.pixelSize()));
		return lengths.append(contours.size() > MOST ? " + ..." : "").append(' ')
			.append(calibration.hasLengthUnit() ? calibration.unit() : "px").toString();
	}

	private static String ends(final FrameLook look) {
		return switch (look.hiddenEnds()) {
			case 0 -> "ends clear";
			case 1 -> "one end on a strand";
			default -> look.hiddenEnds() + " ends on strands";
		};
	}
}
