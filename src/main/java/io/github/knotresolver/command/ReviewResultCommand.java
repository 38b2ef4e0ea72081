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
 * {@code Review Result...}: a finished result folder, or the result of the last run, beside its movie, with the doubtful frames first
 * and one click or key to mend each. Needs a display.
 */
@Plugin(type = Command.class, label = "Review Result...", attrs = @Attr(name = "no-legacy"))
public class ReviewResultCommand extends KnotCommand {

	@Parameter(label = "Result (folder)", description = "What Resolve Filament wrote with Out; empty for what it just found in the active image", style = FileWidget.DIRECTORY_STYLE, required = false, persist = false)
	private File result;

	@Override
	void work(final Progress progress) throws IOException {
		if (result == null && Reviews.ofImage(WindowManager.getCurrentImage(), false, () -> {
		}))
			return;
		if (result == null)
			throw new UserException(
				"result is missing, and the active image has no result in memory; name a folder that Resolve Filament wrote.");
		Reviews.open(result.toPath(), false, progress, () -> {
		});
	}
}
