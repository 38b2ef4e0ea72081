package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.io.File;
import java.io.IOException;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

import org.scijava.ItemIO;
import org.scijava.ItemVisibility;
import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;
import org.scijava.widget.FileWidget;

import ij.ImagePlus;
import ij.WindowManager;
import io.github.knotresolver.imagej.FolderSink;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageSelection;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.imagej.ImageView;
import io.github.knotresolver.imagej.RoiConverter;
import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.FormField;
import io.github.knotresolver.imagej.form.FormGroups;
import io.github.knotresolver.io.ParametersJson;
import io.github.knotresolver.io.ProgramVersion;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.FinishedRun;
import io.github.knotresolver.run.ResolveRun;
import io.github.knotresolver.run.ResultSink;
import io.github.knotresolver.run.RunReport;
import io.github.knotresolver.session.Engine;
import io.github.knotresolver.ui.FormCompanion;
import io.github.knotresolver.ui.KeptSession;
import io.github.knotresolver.ui.LiveResult;
import io.github.knotresolver.ui.PreviewBox;
import io.github.knotresolver.ui.RunWindow;
import io.github.knotresolver.ui.model.RunModel;

/**
 * {@code Resolve Filament...}: finds one ordered contour per frame in a movie
 * file or in the active image, whose pixels are never changed. A point selection
 * in the image is the fixed end, an area selection limits the search. Contours
 * go to the image's overlay and, with a display, to the ROI Manager and two
 * tables; without one, the table of frames becomes ImageJ's Results. With
 * {@code out}, a result folder is written.
 * <p>
 * Input that cannot be used cancels the Command, with the sentence as the
 * reason, which is logged as well.
 */
@Plugin(type = Command.class, label = "Resolve Filament...", attrs = @Attr(name = "no-legacy"))
public class ResolveFilamentCommand extends KnotCommand {

	@Parameter(label = "Image", description = "The active one", required = false, persist = false, visibility = ItemVisibility.INVISIBLE)
	private ImagePlus image;

	@Parameter(label = "Movie (file)", description = "Empty for the active image", required = false, persist = false)
	private File movie;

	@Parameter(label = "Fixed end (x,y in pixels)", description = "Empty for the image's point selection or, without one, to have it found", required = false, persist = false)
	private String fixed_end = "";

	@Parameter(label = "Region (x,y,width,height in px)", description = "Where to search; empty for the image's area selection or, without one, everywhere", required = false, persist = false)
	private String region = "";

	@Parameter(label = "Threshold (0..1 or otsu)", description = "Of the stretched intensities", required = false, persist = false)
	private String threshold = "otsu";

	@Parameter(label = "Iterations (steps)", description = "Of the active contour", min = "0", max = "1000", required = false, persist = false)
	private int iterations = 10;

	@Parameter(label = "Contraction bias", description = "Of the active contour; positive shrinks", min = "-1", max = "1", stepSize = "0.1", required = false, persist = false)
	private double contraction_bias = 0.4;

	@Parameter(label = "Smooth factor", description = "Of the mask's outline", min = "0", max = "10", stepSize = "0.1", required = false, persist = false)
	private double smooth_factor = 0.2;

	@Parameter(label = "Segmentation", description = "What makes the mask; threshold and published method get both", choices = {
		"evidence", "both", "threshold", "active_contour"}, required = false, persist = false)
	private String segmentation = "evidence";

	@Parameter(label = "Polarity", description = "Whether filaments are brighter or darker than their background", choices = {
		"auto", "bright", "dark"}, required = false, persist = false)
	private String polarity = "auto";

	@Parameter(label = "LoG size (px, odd; 0: off)", description = "Edge of a Laplacian of Gaussian, for uneven background", min = "0", max = "99", required = false, persist = false)
	private int log_size = 0;

	@Parameter(label = "LoG sigma (px; 0: off)", description = "Its standard deviation", min = "0", max = "50", required = false, persist = false)
	private double log_sigma = 0;

	@Parameter(label = "Candidates", description = "How contours are proposed", choices = {"trails",
		"paper"}, required = false, persist = false)
	private String candidates = "trails";

	@Parameter(label = "Resolver", description = "How one is chosen", choices = {"movie",
		"paper"}, required = false, persist = false)
	private String resolver = "movie";

	@Parameter(label = "Length (if known; image's unit)", description = "Of the filament; empty to estimate it", required = false, persist = false)
	private String length = "";

	@Parameter(label = "Length model", description = "auto: the same in all frames unless the movie says otherwise; free: what each frame says", choices = {
		"auto", "constant", "free"}, required = false, persist = false)
	private String length_model = "auto";

	@Parameter(label = "Filaments", description = "auto: all, or the one whose fixed end is told", choices = {
		"auto", "one", "all"}, required = false, persist = false)
	private String filaments = "auto";

	@Parameter(label = "Anchor", description = "Whether filaments are held at one end", choices = {
		"auto", "clamped", "free"}, required = false, persist = false)
	private String anchor = "auto";

	@Parameter(label = "Refine (sub-pixel)", description = "Fit the filament to the image", required = false, persist = false)
	private boolean refine = true;

	@Parameter(label = "Channel", description = "Of the filament", min = "1", required = false, persist = false)
	private int channel = 1;

	@Parameter(label = "Z as time (slices are frames)", description = "Read the slices of a Z-stack as frames", required = false, persist = false)
	private boolean z_as_time = false;

	@Parameter(label = "Frames (as 1-40,45)", description = "Empty for all", required = false, persist = false)
	private String frames = "";

	@Parameter(label = "Ignored frames", description = "Frames to leave out, likewise", required = false, persist = false, attrs = @Attr(name = FormField.KEY, value = "ignored"))
	private String ignore_frames = "";

	@Parameter(label = "Corrections (CSV)", description = "What you say of frames: contours, places passed, tips, refusals, exchanges", required = false, persist = false)
	private File corrections;

	@Parameter(label = "Pixel size", description = "Edge of a pixel in the unit beside; empty for the image's", required = false, persist = false)
	private String pixel_size = "";

	@Parameter(label = "Frame interval (s)", description = "Seconds from frame to frame; empty for the image's", required = false, persist = false)
	private String frame_interval = "";

	@Parameter(label = "Unit", description = "Of the pixel size, such as µm; empty for the image's", required = false, persist = false)
	private String unit = "";

	@Parameter(label = "Threads (0: all cores)", description = "The result does not depend on them", min = "0", required = false, persist = false)
	private int threads = 0;

	@Parameter(label = "Out (result folder)", description = "Empty to write no files", style = FileWidget.DIRECTORY_STYLE, required = false, persist = false)
	private File out;

	@Parameter(label = "Plots in the folder", description = "Written with the result", required = false, persist = false)
	private boolean plots = true;

	@Parameter(label = "Force (replace a result)", description = "Replace the files of an earlier result in the folder; your own stay", required = false, persist = false)
	private boolean force = false;

	@Parameter(label = "Overlay", description = "Contours over the image, coloured along their length", required = false, persist = false)
	private boolean overlay = true;

	@Parameter(label = "ROI manager", description = "One polyline a frame, coloured by its confidence", required = false, persist = false)
	private boolean roi_manager = true;

	@Parameter(label = "Tables", description = "One row a point, one row a frame", required = false, persist = false)
	private boolean tables = true;

	@Parameter(type = ItemIO.OUTPUT)
	private Tracks resolution;

	private Engine engine = Engine.PIPELINE;

	/** @param other what resolves movies instead of a session */
	void setEngine(final Engine other) {
		engine = other;
	}

	@Override
	FormGroups groups() {
		return ResolveGroups.ALL;
	}

	@Override
	Optional<FormCompanion> companion() {
		return Optional.of(new PreviewBox());
	}

	@Override
	boolean askForMissing() {
		if (movie != null)
			return true;
		final ImagePlus input = image != null ? image : WindowManager.getCurrentImage();
		if (input == null)
			return true;
		final MovieQuestions questions = new MovieQuestions(input);
		final Optional<Boolean> along = questions.isTimeAlongZ(z_as_time);
		along.ifPresent(yes -> z_as_time = yes);
		if (along.isEmpty())
			return false;
		final Form form = Form.of(this);
		final Optional<Map<String, String>> units = questions.calibration(form.texts());
		units.ifPresent(form::fill);
		return units.isPresent();
	}

	@Override
	void check() {
		super.check();
		RunOptions.parse(texts());
	}

	@Override
	void work(final Progress progress) throws IOException {
		final ImagePlus input = input(progress);
		final RunModel model = new RunModel(progress);
		final Optional<RunWindow> window = isWatched()
			? Optional.of(RunWindow.watch(model, input))
			: Optional.empty();
		try {
			work(input, model, window);
		} finally {
			window.ifPresent(RunWindow::close);
		}
	}

	private void work(final ImagePlus input, final RunModel progress,
		final Optional<RunWindow> window) throws IOException {
		final long start = System.nanoTime();
		final Map<String, String> texts = ImageSelection.over(texts(), input);
		final ResolveRun run = ResolveRun.of(texts);
		final KeptSession session = new KeptSession(input);
		if (engine == Engine.PIPELINE && !GraphicsEnvironment.isHeadless())
			engine = session;
		final ImageSource source = ImageSource.of(input);
		final FinishedRun outcome = out == null
			? resolve(run, source, ResultSink.NONE, progress)
			: intoFolder(run, source, progress);
		final MeasuredTracks result = outcome.result();
		final RoiConverter rois = source.rois();
		progress.checkCancelled();
		window.ifPresent(RunWindow::clear);
		final ShownParts shown = new ShownParts(overlay, roi_manager, tables);
		if (!shown.of(result, input, rois, movie != null))
			say("The Results table holds rows of others, so the frames were not put there; run(\"Clear Results\") before.");
		resolution = result.tracks();
		report(outcome, System.nanoTime() - start);
		if (GraphicsEnvironment.isHeadless())
			return;
		ImageView.front(input, result.tracks());
		if (engine == session && input.getWindow() != null)
			LiveResult.keep(input, new LiveResult(result.tracks(), session, texts,
				Optional.ofNullable(out).map(File::toPath)));
		window.ifPresent(w -> w.done(result.tracks()));
	}

	private FinishedRun resolve(final ResolveRun run, final ImageSource source,
		final ResultSink sink, final RunModel progress) throws IOException {
		final ResolveRun.Work work = run.read(source, progress);
		progress.frames(work.frames());
		return work.resolve(engine, sink, progress);
	}

	private FinishedRun intoFolder(final ResolveRun run, final ImageSource source,
		final RunModel progress) throws IOException {
		try (ResultFolder folder = ResultFolder.reserve(out.toPath(), ResultKind.RESOLVED_MOVIE,
			force, run.files(source))) {
			return resolve(run, source, new FolderSink(folder, source, plots), progress);
		}
	}

	private ImagePlus input(final Progress progress) {
		if (movie != null)
			return ImageFile.open(movie.toPath(), progress);
		final ImagePlus active = image != null ? image : WindowManager.getCurrentImage();
		if (active == null)
			throw new UserException(
				"There is no image open; open a movie, or name its file with movie=FILE.");
		return active;
	}

	/** All options as text, by the names that all front doors share. */
	private Map<String, String> texts() {
		final Map<String, String> texts = Form.of(this).texts();
		texts.keySet().retainAll(RunOptions.KEYS);
		if (threads == 0)
			texts.remove("threads");
		return texts;
	}

	private void report(final FinishedRun outcome, final long nanos) {
		final MeasuredTracks result = outcome.result();
		say(ProgramVersion.NAME + " " + ProgramVersion.get() + ": "
			+ ParametersJson.line(result.tracks(), outcome.input()));
		outcome.report().forEach(this::say);
		RunReport.reasons(result).forEach(this::say);
		say(String.format(Locale.ROOT, "Time: %.1f s.", nanos / 1e9));
	}
}
