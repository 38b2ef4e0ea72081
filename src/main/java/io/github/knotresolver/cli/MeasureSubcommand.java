package io.github.knotresolver.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;

import io.github.knotresolver.imagej.plot.MeasurementFolder;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.FilamentMeasurements;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.MeasureRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
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

	@Option(names = "--spectra", paramLabel = "LIST", description = "Quantities whose spectra are wanted, such as tip_angle,length [tip_angle].")
	private String spectra;

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
		final Path target = out != null
			? out
			: Usage.of(spec, () -> MeasurementFolder.beside(input));
		final List<FilamentMeasurements> all;
		final List<String> notes;
		try (ResultFolder folder = Usage.of(spec, () -> ResultFolder.reserve(target,
			ResultKind.MEASUREMENT, force, List.of(input, input.resolve(ContoursCsv.FILE))))) {
			all = Usage.of(spec, () -> options().measure(ContourInput.readAll(input), progress));
			notes = MeasurementFolder.write(all, folder, plots, originalDefinitions, progress);
		}
		MeasurementFolder.report(all).forEach(spec.commandLine().getOut()::println);
		notes.forEach(spec.commandLine().getErr()::println);
		spec.commandLine().getOut().println("Written to " + target + ".");
		return ExitStatus.FINISHED;
	}

	private MeasureRun options() {
		final Map<String, String> texts = new HashMap<>();
		texts.put("pixel_size", pixelSize);
		texts.put("unit", unit);
		texts.put("frame_interval", frameInterval);
		texts.put("smoothing_window", window);
		texts.put("smoothing_order", order);
		texts.put("persistence_length", persistenceLength);
		texts.put("rigidity", rigidity);
		texts.put("spectra", spectra);
		return MeasureRun.parse(texts);
	}
}
