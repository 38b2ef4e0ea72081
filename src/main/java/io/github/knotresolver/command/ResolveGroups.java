package io.github.knotresolver.command;

import io.github.knotresolver.imagej.form.FormGroups;

/** How the dialog of {@link ResolveFilamentCommand} is divided. */
final class ResolveGroups {

	/** What everyone meets, and the rest in the order in which data flows. */
	static final FormGroups ALL = FormGroups
		.basic("image", "movie", "filaments", "channel", "frames", "length", "out")
		.and("Calibration", "pixel_size", "unit", "frame_interval", "z_as_time")
		.and("Where to look", "fixed_end", "region", "ignore_frames", "corrections")
		.and("From frame to mask", "polarity", "segmentation", "log_size", "log_sigma", "threshold",
			"iterations", "contraction_bias", "smooth_factor")
		.and("How contours are resolved", "anchor", "length_model", "candidates", "resolver",
			"refine", "threads")
		.and("What comes of it", "overlay", "roi_manager", "tables", "plots", "force");

	private ResolveGroups() {
	}
}
