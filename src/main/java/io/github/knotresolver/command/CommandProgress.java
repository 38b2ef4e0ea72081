package io.github.knotresolver.command;

import java.util.function.BooleanSupplier;

import org.scijava.app.StatusService;

import ij.IJ;
import io.github.knotresolver.progress.Progress;

/**
 * Progress of a Command: in ImageJ's window if there is one (Esc cancels), else
 * to SciJava's status; the Command's own cancel counts always.
 */
final class CommandProgress implements Progress, AutoCloseable {

	private static final int STEPS = 100;
	private static final double LAST = 0.999;

	private final StatusService status;
	private final BooleanSupplier cancelled;

	CommandProgress(final StatusService status, final BooleanSupplier cancelled) {
		this.status = status;
		this.cancelled = cancelled;
		// An Esc that was pressed before is not meant.
		IJ.resetEscape();
	}

	@Override
	public void report(final String stage, final double fraction) {
		if (IJ.getInstance() != null) {
			IJ.showStatus(stage + "...");
			// ImageJ takes the bar away at 1.
			IJ.showProgress(Math.min(LAST, fraction));
		} else if (status != null)
			status.showStatus((int) (STEPS * fraction), STEPS, stage);
	}

	@Override
	public boolean isCancelled() {
		return cancelled.getAsBoolean() || IJ.escapePressed();
	}

	@Override
	public void close() {
		if (IJ.getInstance() != null) {
			IJ.showStatus("");
			IJ.showProgress(1);
			IJ.resetEscape();
		} else if (status != null)
			status.clearStatus();
	}
}
