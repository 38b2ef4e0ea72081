package io.github.knotresolver.imagej;

import ij.IJ;
import io.github.knotresolver.progress.Progress;

/**
 * Progress in ImageJ's main window; Esc cancels. Without a window it shows
 * nothing.
 */
public final class ImageJProgress implements Progress, AutoCloseable {

	/** Forgets an Esc that was pressed before. */
	public ImageJProgress() {
		IJ.resetEscape();
	}

	@Override
	public void report(final String stage, final double fraction) {
		IJ.showStatus(stage + "...");
		IJ.showProgress(Math.min(0.999, fraction));
	}

	@Override
	public boolean isCancelled() {
		return IJ.escapePressed();
	}

	/** Leaves ImageJ as it was. */
	@Override
	public void close() {
		IJ.showStatus("");
		IJ.showProgress(1);
		IJ.resetEscape();
	}
}
