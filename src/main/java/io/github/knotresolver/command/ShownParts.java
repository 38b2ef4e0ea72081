package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.util.List;
import java.util.Optional;

import ij.ImagePlus;
import ij.WindowManager;
import ij.plugin.frame.RoiManager;
import io.github.knotresolver.imagej.ContourTables;
import io.github.knotresolver.imagej.ResultDisplay;
import io.github.knotresolver.imagej.RoiConverter;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.ui.TableClicks;

/**
 * What is shown of a result in ImageJ.
 *
 * @param overlay contours over the image
 * @param rois polylines in the ROI Manager
 * @param tables of contours and frames
 */
record ShownParts(boolean overlay, boolean rois, boolean tables) {

	/**
	 * Shows a result. An image that was hidden stays hidden; one that was opened by the Command is shown.
	 *
	 * @param result the result
	 * @param image of the movie
	 * @param converter makes ROIs for it
	 * @param opened whether the Command has opened the image
	 * @return false if the frames could not be put into a table
	 */
	boolean of(final MeasuredTracks result, final ImagePlus image, final RoiConverter converter,
		final boolean opened) {
		final ResultDisplay display = new ResultDisplay(image, result.tracks(), converter);
		if (overlay)
			display.overlay();
		final boolean visible = !GraphicsEnvironment.isHeadless();
		if (opened && visible)
			image.show();
		if (rois && visible)
			display.fill(manager());
		final boolean complete = !tables || new ContourTables(image.getTitle(), result).show();
		// Tables stay open when the image is closed, and must not keep it.
		final int id = image.getID();
		if (tables && visible)
			for (final String table : List.of("-contours", "-frames"))
				TableClicks.lead(image.getTitle() + table,
					() -> Optional.ofNullable(WindowManager.getImage(id)), 1);
		return complete;
	}

	/** That of a macro in batch mode stays hidden. */
	private static RoiManager manager() {
		final RoiManager present = RoiManager.getInstance2();
		return present == null ? RoiManager.getRoiManager() : present;
	}
}
