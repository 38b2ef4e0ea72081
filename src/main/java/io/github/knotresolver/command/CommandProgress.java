package io.github.knotresolver.command;

import java.util.function.BooleanSupplier;

import org.scijava.app.StatusService;

import ij.IJ;
import io.github.knotresolver.imagej.ImageJProgress;
import io.github.knotresolver.progress.Progress;

/**
 * Progress of a Command: in ImageJ's window if there is one (Esc cancels), else
 * to SciJava's status; the Command's own cancel counts always.
 */
final class CommandProgress implements Progress, AutoCloseable {

	private static final int STEPS = 100;

	private final StatusService status;
	private final BooleanSupplier cancelled;
	private final ImageJProgress window = new ImageJProgress();

	CommandProgress(final StatusService status, final BooleanSupplier cancelled) {
		this.status = status;
		this.cancelled = cancelled;
	}

	@Override
	public void report(final String stage, final double fraction) {
		if (IJ.getInstance() != null)
			window.report(stage, fraction);
		else if (status != null)
			status.showStatus((int) (STEPS * fraction), STEPS, stage);
	}

	@Override
	public boolean isCancelled() {
		return cancelled.getAsBoolean() || window.isCancelled();
	}

	@Override
	public void close() {
		if (IJ.getInstance() != null)
			window.close();
		else if (status != null)
			status.clearStatus();
	}
}
