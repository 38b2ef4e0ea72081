package io.github.knotresolver.imagej.plot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

import io.github.knotresolver.io.FilamentMeasurements;
import io.github.knotresolver.io.MeasurementTables;
import io.github.knotresolver.io.OriginalFiles;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
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
	 * Writes a complete folder or nothing. Tables come first; a figure that cannot be
	 * drawn is left out.
	 *
	 * @param all the measurements of every filament, at least one
	 * @param folder the reserved folder; committed here
	 * @param plots whether figures are drawn
	 * @param original whether to measure by the original tool's definitions, too
	 * @param progress may cancel; nothing is left then
	 * @return what was left out and why, a sentence or two each
	 * @throws IOException if a file cannot be written
	 */
	public static List<String> write(final List<FilamentMeasurements> all,
		final ResultFolder folder, final boolean plots, final boolean original,
		final Progress progress) throws IOException {
		new MeasurementTables(all).write(folder.path());
		final Pictures pictures = new Pictures(folder.path());
		for (final FilamentMeasurements f : all) {
			final String suffix = MeasuredFilament.suffix(f.filament());
			final MovieMeasurements m = f.measurements();
			if (original)
				OriginalFiles.writeStatistics(
					folder.path().resolve(OriginalFiles.STATISTICS.replace(".", suffix + ".")),
					f.originalQuantities(), m.calibration(), m.calibration().frequencyUnit());
			if (plots)
				Figures.write(pictures, suffix, m, progress);
		}
		progress.checkCancelled();
		folder.commit();
		return pictures.notes();
	}

	/**
	 * @param all the measurements of every filament
	 * @return what came of them, in two lines each
	 */
	public static List<String> report(final List<FilamentMeasurements> all) {
		return all.stream()
			.flatMap(f -> report(f.measurements()).stream()
				.map(line -> all.size() > 1 ? "Filament " + f.filament() + ": " + line : line))
			.toList();
	}

	private static List<String> report(final MovieMeasurements m) {
		return List.of(
			String.format(Locale.ROOT, "%d of %d frames measured; smoothing window %.3g %s.",
				m.measured().size(), m.frames().size(), m.smoothing().window(),
				m.calibration().unit()),
			m.dominantFrequency(Quantity.TIP_ANGLE)
				.map(d -> String.format(Locale.ROOT,
					"Tip angle: %.3g ± %.1g %s, false-alarm probability %.2g%s.", d.frequency(),
					d.standardError(), m.calibration().frequencyUnit(), d.falseAlarmProbability(),
					d.isSignificant() ? "" : " (may be noise)"))
				.orElse("Tip angle: too few frames for a frequency."));
	}
}
