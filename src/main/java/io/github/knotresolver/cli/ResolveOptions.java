package io.github.knotresolver.cli;

import java.util.Map;
import java.util.TreeMap;

import io.github.knotresolver.io.RunOptions;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;

/**
 * The options that decide a result, as the command line shows them. Their texts
 * are read and checked by {@link io.github.knotresolver.io.RunOptions}, under
 * the same names.
 */
final class ResolveOptions {

	@Option(names = "--fixed-end", paramLabel = "X,Y", description = "Clamped end in pixels [found automatically].")
	private String fixedEnd;

	@Option(names = "--region", paramLabel = "X,Y,W,H", description = "Search only there: left column, upper row, width, height in pixels [everywhere].")
	private String region;

	@Option(names = "--threshold", paramLabel = "T", description = "Intensity 0..1 above which a pixel starts as filament, or otsu [otsu].")
	private String threshold;

	@Option(names = "--iterations", paramLabel = "N", description = "Iterations of the active contour [10].")
	private String iterations;

	@Option(names = "--contraction-bias", paramLabel = "B", description = "-1..1; positive shrinks the mask [0.4].")
	private String contractionBias;

	@Option(names = "--smooth-factor", paramLabel = "S", description = "Smoothness of the mask's outline [0.2].")
	private String smoothFactor;

	@Option(names = "--segmentation", paramLabel = "STEPS", description = "What makes the mask: both, threshold or active-contour, alone [both].")
	private String segmentation;

	@Option(names = "--log-size", paramLabel = "N", description = "Edge of a Laplacian of Gaussian in pixels, odd, for uneven background [off].")
	private String logSize;

	@Option(names = "--log-sigma", paramLabel = "S", description = "Its standard deviation in pixels [off].")
	private String logSigma;

	@Option(names = "--candidates", paramLabel = "KIND", description = "How contours are proposed: paper or trails [trails].")
	private String candidates;

	@Option(names = "--resolver", paramLabel = "KIND", description = "How one is chosen: paper or movie [movie].")
	private String resolver;

	@Option(names = "--length", paramLabel = "L", description = "Known length of the filament in the image's unit [estimated].")
	private String length;

	@Option(names = "--length-model", paramLabel = "KIND", description = "constant, or free for a filament that grows or shrinks [constant].")
	private String lengthModel;

	@Option(names = "--refine", negatable = true, defaultValue = "true", fallbackValue = "true", description = "Fit the filament to the image, sub-pixel, or not [on].")
	private boolean refine;

	@Option(names = "--channel", paramLabel = "N", description = "Channel of the filament [1].")
	private String channel;

	@Option(names = "--z-as-time", description = "Read the slices of a Z-stack as frames.")
	private boolean zAsTime;

	@Option(names = "--frames", paramLabel = "LIST", description = "Frames to resolve, such as 1-40,45 [all].")
	private String frames;

	@Option(names = "--ignore-frames", paramLabel = "LIST", description = "Frames to leave out [none].")
	private String ignoreFrames;

	@Option(names = "--corrections", paramLabel = "FILE", description = "Contours that you drew: CSV with frame,index,x_px,y_px [none].")
	private String corrections;

	@Option(names = "--pixel-size", paramLabel = "P", description = "Edge of a pixel [from the image].")
	private String pixelSize;

	@Option(names = "--frame-interval", paramLabel = "S", description = "Seconds between frames [from the image].")
	private String frameInterval;

	@Option(names = "--unit", paramLabel = "U", description = "Unit of the pixel size [from the image, else µm].")
	private String unit;

	@Option(names = "--threads", paramLabel = "N", description = "Threads; the result does not depend on them [all cores].")
	private String threads;

	/**
	 * @param spec a subcommand with these options, parsed
	 * @return the options that were given, by the keys that all front doors share
	 */
	static Map<String, String> given(final CommandSpec spec) {
		final Map<String, String> texts = new TreeMap<>();
		for (final OptionSpec option : spec.commandLine().getParseResult().matchedOptions()) {
			final String key = option.longestName().substring(2).replace('-', '_');
			if (RunOptions.KEYS.contains(key))
				texts.put(key, String.valueOf(option.<Object>getValue()));
		}
		return texts;
	}
}
