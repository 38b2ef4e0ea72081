package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

import javax.swing.SwingUtilities;

import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;
import org.scijava.widget.FileWidget;

import ij.IJ;
import ij.ImagePlus;
import ij.WindowManager;
import ij.macro.Interpreter;
import ij.plugin.frame.RoiManager;
import io.github.knotresolver.imagej.RoiContours;
import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.plot.LiveFigure;
import io.github.knotresolver.imagej.plot.MeasurementFolder;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.FilamentMeasurements;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.MeasureRun;
import io.github.knotresolver.ui.MeasureWindow;
import io.github.knotresolver.ui.ShownFrame;

/**
 * {@code Measure Contours...}: lengths, angles, curvature, oscillations and
 * waves of the contours of a result folder, of a file, or of the ROI Manager.
 */
@Plugin(type = Command.class, label = "Measure Contours...", attrs = @Attr(name = "no-legacy"))
public class MeasureContoursCommand extends KnotCommand {

	@Parameter(label = "Result (folder or CSV)", description = "A result folder, a contours.csv or the original tool's MTdata.csv; empty for the polylines in the ROI Manager", required = false, persist = false)
	private File result;

	@Parameter(label = "Pixel size", description = "Empty for the result's or the active image's", required = false, persist = false)
	private String pixel_size = "";

	@Parameter(label = "Unit", description = "Of the pixel size, likewise", required = false, persist = false)
	private String unit = "";

	@Parameter(label = "Frame interval (s)", description = "Likewise", required = false, persist = false)
	private String frame_interval = "";

	@Parameter(label = "Smoothing window", description = "Along the contour, in the unit of length; empty to derive it from the data", required = false, persist = false)
	private String smoothing_window = "";

	@Parameter(label = "Smoothing order", description = "Degree of the smoothing's polynomial", min = "2", max = "5", required = false, persist = false)
	private int smoothing_order = 3;

	@Parameter(label = "Persistence length", description = "In the unit of length: gives bending energies in kT", required = false, persist = false)
	private String persistence_length = "";

	@Parameter(label = "Rigidity (pN µm²)", description = "Gives bending energies in pN µm", required = false, persist = false)
	private String rigidity = "";

	@Parameter(label = "Spectra of", description = "Quantities, such as tip_angle,end_to_end,length", required = false, persist = false)
	private String spectra = "tip_angle";

	@Parameter(label = "Out (folder)", description = "Empty to write no files", style = FileWidget.DIRECTORY_STYLE, required = false, persist = false)
	private File out;

	@Parameter(label = "Plots in the folder", description = "Written with the tables", required = false, persist = false)
	private boolean plots = true;

	@Parameter(label = "Original definitions", description = "Also write statsSummary.txt by the original tool's definitions", required = false, persist = false)
	private boolean original_definitions = false;

	@Parameter(label = "Force (replace measurements)", required = false, persist = false)
	private boolean force = false;

	@Parameter(label = "Show table, plots and kymographs", required = false, persist = false)
	private boolean show = true;

	@Override
	void work(final Progress progress) throws IOException {
		final List<FilamentMeasurements> all;
		if (out == null)
			all = measure(progress);
		else
			try (ResultFolder folder = ResultFolder.reserve(out.toPath(), ResultKind.MEASUREMENT,
				force, inputs())) {
				all = measure(progress);
				MeasurementFolder.write(all, folder, plots, original_definitions, progress)
					.forEach(this::say);
			}
		progress.checkCancelled();
		if (show && !GraphicsEnvironment.isHeadless())
			show(all);
		MeasurementFolder.report(all).forEach(this::say);
	}

	private List<Path> inputs() {
		return result == null
			? List.of()
			: List.of(result.toPath(), result.toPath().resolve(ContoursCsv.FILE));
	}

	private List<FilamentMeasurements> measure(final Progress progress) {
		final Map<String, String> texts = Form.of(this).texts();
		texts.keySet().retainAll(MeasureRun.KEYS);
		return MeasureRun.parse(texts).measure(contours(), progress);
	}

	private List<ContourInput> contours() {
		if (result != null)
			return ContourInput.readAll(result.toPath());
		// Without a display there is no ROI Manager; in a batch macro it is another one.
		final RoiManager manager = GraphicsEnvironment.isHeadless()
			? RoiManager.getRawInstance()
			: RoiManager.getInstance2();
		return RoiContours.read(manager, WindowManager.getCurrentImage());
	}

	/** One window for a person; a macro finds the tables, and in batch mode hidden plots. */
	private void show(final List<FilamentMeasurements> all) {
		final List<MeasureWindow.Item> items = all.stream()
			.map(f -> new MeasureWindow.Item(f.filament(), f.measurements())).toList();
		final Supplier<Optional<ImagePlus>> image = image();
		if (Interpreter.isBatchMode() || IJ.isMacro())
			items.forEach(i -> MeasureWindow.showTable(i, image));
		if (Interpreter.isBatchMode())
			items.forEach(i -> LiveFigure.of(i.measurements()).forEach(LiveFigure::showInImageJ));
		else
			SwingUtilities.invokeLater(() -> MeasureWindow.open(name(), items, image));
	}

	private String name() {
		if (result != null)
			return result.getName();
		final ImagePlus current = WindowManager.getCurrentImage();
		return current == null ? "contours" : current.getTitle();
	}

	/** The movie of a result folder, if it is open; of the ROI Manager, the active image. */
	private Supplier<Optional<ImagePlus>> image() {
		final ImagePlus current = WindowManager.getCurrentImage();
		final int id = current == null ? 0 : current.getID();
		if (result == null)
			return () -> Optional.ofNullable(id == 0 ? null : WindowManager.getImage(id));
		final Optional<Path> movie = RunIdentity.read(result.toPath()).map(RunIdentity::movie);
		return () -> movie.flatMap(ShownFrame::image);
	}
}
