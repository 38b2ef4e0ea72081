package io.github.knotresolver.run;

import java.util.LinkedHashMap;
import java.util.Map;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.OptionText;
import io.github.knotresolver.simulate.BitDepth;
import io.github.knotresolver.simulate.FrameRenderer;
import io.github.knotresolver.simulate.OpticalRenderer;
import io.github.knotresolver.simulate.Optics;
import io.github.knotresolver.simulate.PaperRenderer;

/**
 * How a simulated trajectory becomes a movie.
 *
 * @param optical microscope and camera, or the published rendering
 * @param pixelSize in µm
 * @param margin pixels around the filament
 * @param bits of a pixel: 8 or 16
 * @param snr signal-to-noise ratio in dB, or {@code inf}; published rendering only
 * @param optics of microscope and camera
 */
public record Rendering(boolean optical, double pixelSize, int margin, int bits, String snr,
	Optics optics) {

	/** The usual number of pixels around the filament. */
	public static final int MARGIN = 20;

	/**
	 * @return bits of a pixel
	 * @throws UserException if there are no such pixels
	 */
	BitDepth depth() {
		return switch (bits) {
			case 8 -> BitDepth.EIGHT;
			case 16 -> BitDepth.SIXTEEN;
			default -> throw new UserException(
				"bits must be 8 or 16, but is " + bits + "; choose one of them.");
		};
	}

	/**
	 * @param seed start of the random numbers
	 * @return what draws a frame
	 * @throws UserException if an option is out of range
	 */
	FrameRenderer renderer(final long seed) {
		return optical ? new OpticalRenderer(optics, seed) : new PaperRenderer(decibel(), seed);
	}

	private double decibel() {
		if (snr.strip().equalsIgnoreCase("inf"))
			return Double.POSITIVE_INFINITY;
		return OptionText.number("snr", snr, "a number of dB from -30 to 100, or inf");
	}

	/** @return the options that were used, for {@code parameters.json} */
	Map<String, Object> settings() {
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put("rendering", optical ? "optical" : "paper");
		json.put("pixel_size", pixelSize);
		json.put("margin", margin);
		json.put("bits", bits);
		if (optical)
			json.put("optics", optics);
		else
			json.put("snr", snr);
		return json;
	}
}
