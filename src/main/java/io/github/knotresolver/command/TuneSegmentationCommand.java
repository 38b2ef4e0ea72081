package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.util.LinkedHashMap;
import java.util.Map;

import org.scijava.ItemVisibility;
import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;

import ij.ImagePlus;
import ij.WindowManager;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.ui.TuneWindow;
import io.github.knotresolver.ui.model.TuneModel;

/**
 * {@code Tune Segmentation...}: threshold, active contour and Laplacian of Gaussian with what they do in
 * every frame of the active image, to be written into a batch sheet or used in
 * {@code Resolve Filament...}. Needs a display.
 */
@Plugin(type = Command.class, label = "Tune Segmentation...", attrs = @Attr(name = "no-legacy"))
public class TuneSegmentationCommand extends KnotCommand {

	@Parameter(label = "Image", description = "The active one", required = false, persist = false, visibility = ItemVisibility.INVISIBLE)
	private ImagePlus image;

	@Parameter(label = "Channel", description = "Of the filament", min = "1", required = false, persist = false)
	private int channel = 1;

	@Override
	void work(final Progress progress) {
		if (GraphicsEnvironment.isHeadless())
			throw new UserException(
				"Tuning needs a display; without one, give Resolve Filament... a threshold.");
		final ImagePlus active = image != null ? image : WindowManager.getCurrentImage();
		if (active == null || active.getWindow() == null)
			throw new UserException("There is no image open; open a movie, and tune it then.");
		final String along = Boolean.toString(ImageMovie.isTimeElsewhere(active));
		final InputOptions input = RunOptions
			.parse(Map.of("channel", Integer.toString(channel), "z_as_time", along)).input();
		final TuneModel model = new TuneModel(ImageSource.of(active).read(input, progress),
			TuneWindow.frame(active));
		TuneWindow.open(model, active, channel,
			texts -> CommandPlugIn.open(ResolveFilamentCommand.class.getSimpleName(), with(texts)));
	}

	private Map<String, String> with(final Map<String, String> texts) {
		final Map<String, String> all = new LinkedHashMap<>(texts);
		all.put("channel", Integer.toString(channel));
		return all;
	}
}
