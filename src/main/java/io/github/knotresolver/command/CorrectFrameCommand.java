package io.github.knotresolver.command;

import java.io.File;
import java.io.IOException;

import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;
import org.scijava.widget.FileWidget;

import ij.WindowManager;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.ui.Reviews;

/**
 * {@code Correct Frame...}: the review of a result at the frame that the active image shows; that
 * which is open already comes to the front. Needs a display.
 */
@Plugin(type = Command.class, label = "Correct Frame...", attrs = @Attr(name = "no-legacy"))
public class CorrectFrameCommand extends KnotCommand {

	@Parameter(label = "Result (folder)", description = "What Resolve Filament wrote with Out; empty for what it just found in the active image", style = FileWidget.DIRECTORY_STYLE, required = false, persist = false)
	private File result;

	@Override
	void work(final Progress progress) throws IOException {
		if (result == null && Reviews.ofImage(WindowManager.getCurrentImage(), true, () -> {
		}))
			return;
		if (result == null)
			throw new UserException(
				"result is missing, and the active image has no result in memory; name the folder that Resolve Filament wrote.");
		Reviews.open(result.toPath(), true, progress, () -> {
		});
	}
}
