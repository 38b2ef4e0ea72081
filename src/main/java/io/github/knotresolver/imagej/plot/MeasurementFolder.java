package io.github.knotresolver.imagej.plot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.io.MeasurementTables;
import io.github.knotresolver.io.OriginalFiles;
import io.github.knotresolver.io.OriginalStatistics;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.OriginalQuantities;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** Measurements as a folder of tables and figures, and in a few lines. */
public final class MeasurementFolder {

	private MeasurementFolder() {
	}

	/**
	 * @param input a result folder or a file of contours
	 * @return the folder beside it where its measurements go if no other is named
	 * @throws UserException if it is the root of the file system
	 */
	public static Path beside(final Path input) {
		final Path path = input.toAbsolutePath().normalize();
		if (path.getFileName() == null)
			throw new UserException(
				input + " is no folder that 'resolve' wrote; name one, or a file of contours.");
		final String name = path.getFileName().toString();
		return path.resolveSibling(
			(Files.isDirectory(path) ? name : name.replaceFirst("(?<=.)\\.[^.]*$", ""))
				+ "-measured");
	}

	/**
	 * Writes a complete folder or nothing.
	 *
	 * @param m the measurements
	 * @param folder the reserved folder; committed here
	 * @param plots whether figures are drawn
	 * @param original the contours, to be measured by the original tool's
	 *          definitions too; null for not
	 * @param progress may cancel; nothing is left then
	 * @throws IOException if the disk says no
	 */
	public static void write(final MovieMeasurements m, final ResultFolder folder,
		final boolean plots, final ContourInput original, final Progress progress)
		throws IOException {
		new MeasurementTables(m).write(folder.path());
		if (original != null)
			OriginalStatistics.write(folder.path().resolve(OriginalFiles.STATISTICS),
				quantities(original, m.calibration()), m.calibration(), m.frequencyUnit());
		if (plots)
			Figures.write(new Pictures(folder.path()), "", m, progress);
		progress.checkCancelled();
		folder.commit();
	}

	private static OriginalQuantities quantities(final ContourInput input, final Calibration c) {
		final List<Integer> frames = new ArrayList<>();
		final List<Polyline> contours = new ArrayList<>();
		for (int i = 0; i < input.contours().size(); i++) {
			if (input.contours().get(i).isEmpty())
				continue;
			frames.add(i + 1);
			contours.add(input.contours().get(i).orElseThrow());
		}
		return OriginalQuantities.of(frames, contours, c.pixelSize(), c.frameInterval());
	}

	/**
	 * @param m the measurements
	 * @return what came of them, in two lines
	 */
	public static List<String> report(final MovieMeasurements m) {
		return List.of(
			String.format(Locale.ROOT, "%d of %d frames measured; smoothing window %.3g %s.",
				m.measured().size(), m.frames().size(), m.smoothing().window(),
				m.calibration().unit()),
			m.dominantFrequency(Quantity.TIP_ANGLE)
				.map(d -> String.format(Locale.ROOT,
					"Tip angle: %.3g ± %.1g %s, false-alarm probability %.2g%s.", d.frequency(),
					d.standardError(), m.frequencyUnit(), d.falseAlarmProbability(),
					d.isSignificant() ? "" : " (may be noise)"))
				.orElse("Tip angle: too few frames for a frequency."));
	}
}
