package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import org.scijava.ItemIO;
import org.scijava.ItemVisibility;
import org.scijava.app.StatusService;
import org.scijava.command.Command;
import org.scijava.command.ContextCommand;
import org.scijava.log.LogService;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;
import org.scijava.widget.FileWidget;

import ij.ImagePlus;
import ij.WindowManager;
import ij.plugin.frame.RoiManager;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.Movie;
import io.github.knotresolver.imagej.ContourTables;
import io.github.knotresolver.imagej.Engine;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.ResultDisplay;
import io.github.knotresolver.imagej.ResultWriter;
import io.github.knotresolver.imagej.RoiConverter;
import io.github.knotresolver.io.MeasuredResolution;
import io.github.knotresolver.io.ProgramVersion;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.RunOptions;
import io.github.knotresolver.io.RunReport;
import io.github.knotresolver.pipeline.Parameters;
import io.github.knotresolver.pipeline.Resolution;
import io.github.knotresolver.progress.CancelledException;

/**
 * {@code Resolve Filament...}: finds one ordered contour per frame in a movie
 * file or in the active image, whose pixels are never changed. A point selection
 * in the image is the fixed end. With a display, contours go to the ROI Manager,
 * the overlay and two tables; with {@code out}, a result folder is written.
 * <p>
 * Input that cannot be used cancels the Command, with the sentence as the
 * reason, which is logged as well.
 */
@Plugin(type = Command.class, label = "Resolve Filament...", attrs = @Attr(name = "no-legacy"))
public class ResolveFilamentCommand extends ContextCommand {

	@Parameter(required = false)
	private LogService log;

	@Parameter(required = false)
	private StatusService status;

	@Parameter(label = "Image", required = false, persist = false, visibility = ItemVisibility.INVISIBLE)
	private ImagePlus image;

	@Parameter(label = "Movie file", description = "Empty for the active image", required = false, persist = false)
	private File movie;

	@Parameter(label = "Fixed end (x,y in pixels)", description = "Empty to have it found", required = false, persist = false)
	private String fixed_end = "";

	@Parameter(label = "Threshold (0..1 or otsu)", required = false, persist = false)
	private String threshold = "otsu";

	@Parameter(label = "Iterations", min = "0", max = "1000", required = false, persist = false)
	private int iterations = 10;

	@Parameter(label = "Contraction bias", min = "-1", max = "1", stepSize = "0.1", required = false, persist = false)
	private double contraction_bias = 0.4;

	@Parameter(label = "Smooth factor", min = "0", max = "10", stepSize = "0.1", required = false, persist = false)
	private double smooth_factor = 0.2;

	@Parameter(label = "LoG size (pixels, odd; 0 = off)", min = "0", max = "99", required = false, persist = false)
	private int log_size = 0;

	@Parameter(label = "LoG sigma (pixels; 0 = off)", min = "0", max = "50", required = false, persist = false)
	private double log_sigma = 0;

	@Parameter(label = "Candidates", choices = {"trails",
		"paper"}, required = false, persist = false)
	private String candidates = "trails";

	@Parameter(label = "Resolver", choices = {"movie", "paper"}, required = false, persist = false)
	private String resolver = "movie";

	@Parameter(label = "Known length (image's unit)", description = "Empty to estimate it", required = false, persist = false)
	private String length = "";

	@Parameter(label = "Length model", choices = {"constant",
		"free"}, required = false, persist = false)
	private String length_model = "constant";

	@Parameter(label = "Refine", required = false, persist = false)
	private boolean refine = true;

	@Parameter(label = "Channel", min = "1", required = false, persist = false)
	private int channel = 1;

	@Parameter(label = "Z slices are frames", required = false, persist = false)
	private boolean z_as_time = false;

	@Parameter(label = "Frames (such as 1-40,45)", description = "Empty for all", required = false, persist = false)
	private String frames = "";

	@Parameter(label = "Ignore frames", required = false, persist = false)
	private String ignore_frames = "";

	@Parameter(label = "Corrections (CSV)", required = false, persist = false)
	private File corrections;

	@Parameter(label = "Pixel size", description = "Empty for the image's", required = false, persist = false)
	private String pixel_size = "";

	@Parameter(label = "Frame interval (s)", description = "Empty for the image's", required = false, persist = false)
	private String frame_interval = "";

	@Parameter(label = "Unit", description = "Empty for the image's", required = false, persist = false)
	private String unit = "";

	@Parameter(label = "Threads (0 = all cores)", min = "0", required = false, persist = false)
	private int threads = 0;

	@Parameter(label = "Result folder", description = "Empty to write no files", style = FileWidget.DIRECTORY_STYLE, required = false, persist = false)
	private File out;

	@Parameter(label = "Plots in the folder", required = false, persist = false)
	private boolean plots = true;

	@Parameter(label = "Replace an existing result", required = false, persist = false)
	private boolean force = false;

	@Parameter(label = "Show ROIs, overlay and tables", required = false, persist = false)
	private boolean show = true;

	@Parameter(type = ItemIO.OUTPUT)
	private Resolution resolution;

	private Engine engine = Engine.PIPELINE;

	/** @param other what resolves movies instead of the pipeline */
	void setEngine(final Engine other) {
		engine = other;
	}

	@Override
	public void run() {
		try (CommandProgress progress = new CommandProgress(status, this::isCanceled)) {
			resolve(progress);
		} catch (final CancelledException e) {
			cancel("Cancelled; nothing was written.");
		} catch (final IllegalArgumentException e) {
			refuse(e.getMessage());
		} catch (final IOException e) {
			refuse("The result could not be written: " + e.getMessage() + ".");
		}
	}

	private void resolve(final CommandProgress progress) throws IOException {
		if (out != null)
			ResultFolder.check(out.toPath(), force);
		final ImagePlus input = input();
		final RunOptions options = RunOptions.parse(texts(input));
		final Movie series = ImageMovie.of(input, options.input());
		final Parameters parameters = options.parameters(series);
		final MeasuredResolution result = MeasuredResolution
			.of(engine.resolve(series, parameters, progress), progress);
		if (out != null)
			new ResultWriter(result, options.input(), input).write(out.toPath(), force, plots,
				progress);
		if (show && !GraphicsEnvironment.isHeadless())
			show(input, result);
		resolution = result.resolution();
		report(RunReport.lines(result));
	}

	private ImagePlus input() {
		if (movie != null)
			return ImageFile.open(movie.toPath());
		final ImagePlus active = image != null ? image : WindowManager.getCurrentImage();
		if (active == null)
			throw new IllegalArgumentException(
				"There is no image open; open a movie, or name its file with movie=FILE.");
		return active;
	}

	/** All options as text, by the keys that all front doors share. */
	private Map<String, String> texts(final ImagePlus input) {
		final Map<String, String> texts = new TreeMap<>();
		final boolean found = fixed_end == null || fixed_end.isBlank();
		texts.put("fixed_end",
			found ? RoiConverter.point(input.getRoi()).map(Point::toString).orElse("") : fixed_end);
		texts.put("threshold", threshold);
		texts.put("iterations", Integer.toString(iterations));
		texts.put("contraction_bias", Double.toString(contraction_bias));
		texts.put("smooth_factor", Double.toString(smooth_factor));
		texts.put("log_size", Integer.toString(log_size));
		texts.put("log_sigma", Double.toString(log_sigma));
		texts.put("candidates", candidates);
		texts.put("resolver", resolver);
		texts.put("length", length);
		texts.put("length_model", length_model);
		texts.put("refine", Boolean.toString(refine));
		texts.put("channel", Integer.toString(channel));
		texts.put("z_as_time", Boolean.toString(z_as_time));
		texts.put("frames", frames);
		texts.put("ignore_frames", ignore_frames);
		texts.put("corrections", corrections == null ? "" : corrections.getPath());
		texts.put("pixel_size", pixel_size);
		texts.put("frame_interval", frame_interval);
		texts.put("unit", unit);
		texts.put("threads", threads == 0 ? "" : Integer.toString(threads));
		return texts;
	}

	private void show(final ImagePlus input, final MeasuredResolution result) {
		if (input.getWindow() == null)
			input.show();
		final ResultDisplay display = new ResultDisplay(input, result.resolution(), channel);
		display.fill(RoiManager.getRoiManager());
		display.overlay();
		new ContourTables(input.getTitle(), result).show();
	}

	private void report(final List<String> lines) {
		if (log == null)
			return;
		log.info(ProgramVersion.NAME + " " + ProgramVersion.get());
		lines.forEach(log::info);
	}

	private void refuse(final String sentence) {
		if (log != null)
			log.error(sentence);
		cancel(sentence);
	}
}
