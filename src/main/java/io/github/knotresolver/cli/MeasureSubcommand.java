package io.github.knotresolver.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;

import io.github.knotresolver.geometry.Calibration;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.plot.Figures;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.io.MeasurementTables;
import io.github.knotresolver.io.OptionText;
import io.github.knotresolver.io.OriginalFiles;
import io.github.knotresolver.io.OriginalStatistics;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.UnitText;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.OriginalQuantities;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.measure.Rigidity;
import io.github.knotresolver.measure.Smoothing;
import io.github.knotresolver.progress.Progress;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code knotresolver measure}: from contours to quantities and figures. */
@Command(name = "measure", mixinStandardHelpOptions = true, sortOptions = false, usageHelpAutoWidth = true, description = "Measures contours: lengths, angles, curvature, oscillations, waves; tables and figures.%n")
final class MeasureSubcommand implements Callable<Integer> {

	@Spec
	private CommandSpec spec;

	@Parameters(paramLabel = "RESULT_DIR", description = "Folder that 'resolve' wrote, or a contours.csv, or the original tool's MTdata.csv.")
	private Path input;

	@Option(names = "--out", paramLabel = "DIR", description = "Folder of the measurements [RESULT_DIR with '-measured' added].")
	private Path out;

	@Option(names = "--force", description = "Replace measurements that are already there.")
	private boolean force;

	@Option(names = "--pixel-size", paramLabel = "P", description = "Edge of a pixel [from the result].")
	private String pixelSize;

	@Option(names = "--unit", paramLabel = "U", description = "Unit of the pixel size [from the result, else µm].")
	private String unit;

	@Option(names = "--frame-interval", paramLabel = "S", description = "Seconds between frames [from the result].")
	private String frameInterval;

	@Option(names = "--smoothing-window", paramLabel = "W", description = "Width of the smoothing along the contour, in the unit [from the data].")
	private String window;

	@Option(names = "--smoothing-order", paramLabel = "N", description = "Degree of the smoothing's polynomial, 2 to 5 [3].")
	private String order;

	@Option(names = "--persistence-length", paramLabel = "L", description = "In the unit of length: gives bending energies in kT [off].")
	private String persistenceLength;

	@Option(names = "--rigidity", paramLabel = "B", description = "In pN µm²: gives bending energies in pN µm [off].")
	private String rigidity;

	@Option(names = "--plots", negatable = true, defaultValue = "true", fallbackValue = "true", description = "Draw figures, or not [on].")
	private boolean plots;

	@Option(names = "--original-definitions", description = "Also write statsSummary.txt by the original tool's definitions.")
	private boolean originalDefinitions;

	private final Progress progress;

	MeasureSubcommand(final Progress progress) {
		this.progress = progress;
	}

	@Override
	public Integer call() throws IOException {
		final ContourInput contours;
		final MovieMeasurements m;
		final Path folder = out != null ? out : beside(input);
		try {
			ResultFolder.check(folder, force);
			contours = ContourInput.read(input);
			final Calibration c = calibration(contours.calibration());
			m = MovieMeasurements.of(contours.name(), contours.contours(), c,
				smoothing(contours, c), stiffness(), progress);
		} catch (final IllegalArgumentException e) {
			throw new ParameterException(spec.commandLine(), e.getMessage(), e);
		}
		try (ResultFolder result = ResultFolder.prepare(folder, force)) {
			new MeasurementTables(m).write(result.path());
			if (originalDefinitions)
				OriginalStatistics.write(result.path().resolve(OriginalFiles.STATISTICS),
					original(contours, m.calibration()), m.calibration(), m.frequencyUnit());
			if (plots)
				Figures.writeAll(result.path(), m, progress);
			progress.checkCancelled();
			result.commit();
		}
		report(m, folder);
		return ExitStatus.FINISHED;
	}

	private static Path beside(final Path input) {
		final Path path = input.toAbsolutePath().normalize();
		return path.resolveSibling(
			path.getFileName().toString().replaceFirst("\\.[^.]*$", "") + "-measured");
	}

	private Calibration calibration(final Calibration told) {
		final double size = pixelSize == null
			? told.pixelSize()
			: OptionText.positive("pixel_size", pixelSize);
		final String length = unit != null
			? UnitText.length(unit)
			: pixelSize != null && !told.hasLengthUnit() ? "µm" : told.unit();
		return frameInterval == null
			? new Calibration(size, length, told.frameInterval(), told.timeUnit())
			: new Calibration(size, length, OptionText.positive("frame_interval", frameInterval),
				"s");
	}

	private Optional<Smoothing> smoothing(final ContourInput contours, final Calibration c) {
		if (window == null && order == null)
			return Optional.empty();
		final double width = window != null
			? OptionText.positive("smoothing_window", window)
			: Smoothing
				.derivedFrom(contours.contours().stream().flatMap(Optional::stream).toList(), c)
				.window();
		return Optional.of(new Smoothing(width,
			order == null
				? Smoothing.DEFAULT_ORDER
				: OptionText.wholeNumber("smoothing_order", order)));
	}

	private Rigidity stiffness() {
		if (persistenceLength != null && rigidity != null)
			throw new IllegalArgumentException(
				"Give either --persistence-length or --rigidity, not both.");
		if (persistenceLength != null)
			return Rigidity
				.ofPersistenceLength(OptionText.positive("persistence_length", persistenceLength));
		return rigidity == null
			? Rigidity.UNKNOWN
			: Rigidity.ofFlexural(OptionText.positive("rigidity", rigidity));
	}

	private static OriginalQuantities original(final ContourInput input, final Calibration c) {
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

	private void report(final MovieMeasurements m, final Path folder) {
		final var stdout = spec.commandLine().getOut();
		stdout.printf(Locale.ROOT, "%d of %d frames measured; smoothing window %.3g %s.%n",
			m.measured().size(), m.frames().size(), m.smoothing().window(), m.calibration().unit());
		m.dominantFrequency(Quantity.TIP_ANGLE).ifPresentOrElse(
			d -> stdout.printf(Locale.ROOT,
				"Tip angle: %.3g ± %.1g %s, false-alarm probability %.2g%s.%n", d.frequency(),
				d.standardError(), m.frequencyUnit(), d.falseAlarmProbability(),
				d.isSignificant() ? "" : " (may be noise)"),
			() -> stdout.println("Tip angle: too few frames for a frequency."));
		stdout.println("Written to " + folder + ".");
	}
}
