package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.measure.LengthStatistics;
import io.github.knotresolver.measure.OriginalQuantities;
import io.github.knotresolver.model.Calibration;

/**
 * {@code statsSummary.txt} in the original tool's format.
 */
public final class OriginalStatistics {

	private OriginalStatistics() {
	}

	/**
	 * @param file the file to write
	 * @param original the quantities
	 * @param c units
	 * @param frequencyUnit unit of the dominant frequency
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final OriginalQuantities original,
		final Calibration c, final String frequencyUnit) throws IOException {
		final LengthStatistics s = LengthStatistics.ofLengths(original.length());
		final String unit = c.unit().equals("µm") ? "micron" : c.unit();
		final List<String> lines = new ArrayList<>(List.of("Statistics Summary",
			"------------------", "Scaling Factor: " + text(c.pixelSize(), 5),
			"Time Step: " + text(c.frameInterval(), 2),
			"Distance ignored from end (" + unit + "s): 0.00",
			"Dominant Frequency (" + frequencyUnit + "): " + text(original.dominantFrequency(), 5),
			"", "Mean Length, Median Length, Std Length, Min Length, Max Length",
			String.join(", ", text(s.mean(), 2), text(s.median(), 2), text(s.sd(), 2),
				text(s.min(), 2), text(s.max(), 2)),
			"Frame, Length (" + unit + "), Tip Angle, Tip Angle (smooth), EndToEndDistance (" + unit
				+ ")"));
		for (int i = 0; i < original.frame().length; i++)
			lines.add(String.join(", ", String.valueOf(original.frame()[i]),
				text(original.length()[i], 3), text(original.tipAngle()[i], 3),
				text(original.smoothTipAngle()[i], 3), text(original.endToEnd()[i], 3)));
		Files.writeString(file, String.join("\n", lines) + "\n", StandardCharsets.UTF_8);
	}

	private static String text(final double value, final int decimals) {
		return Double.isFinite(value) ? NumberText.fixed(value, decimals) : "NaN";
	}
}
