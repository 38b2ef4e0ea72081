package io.github.knotresolver.cli;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.run.Rendering;
import io.github.knotresolver.simulate.Optics;
import picocli.CommandLine.Option;

/** The options that decide the pictures of a simulated trajectory. */
final class RenderOptions {

	/** How a frame is drawn. */
	enum Kind {
		/** The published rendering. */
		PAPER,
		/** Microscope and camera. */
		OPTICAL
	}

	@Option(names = "--rendering", paramLabel = "KIND", defaultValue = "paper", description = "paper: the published one, or optical: microscope and camera [paper].")
	private Kind rendering;

	@Option(names = "--pixel-size", paramLabel = "L", defaultValue = "0.106", description = "In µm [0.106].")
	private double pixelSize;

	@Option(names = "--margin", paramLabel = "N", defaultValue = "20", description = "Pixels around the filament [20].")
	private int margin;

	@Option(names = "--bits", paramLabel = "N", defaultValue = "8", description = "Bits of a pixel: 8 or 16 [8].")
	private int bits;

	@Option(names = "--snr", paramLabel = "DB", defaultValue = "20", description = "Signal-to-noise ratio in dB, or inf for no noise; paper only [20].")
	private String snr;

	@Option(names = "--psf-sigma", paramLabel = "S", defaultValue = "1.5", description = "Width of the point spread function in pixels; this and the rest: optical only [1.5].")
	private double psfSigma;

	@Option(names = "--signal", paramLabel = "N", defaultValue = "100", description = "Photons in a pixel on the filament [100].")
	private double signal;

	@Option(names = "--background", paramLabel = "N", defaultValue = "20", description = "Photons in a pixel elsewhere [20].")
	private double background;

	@Option(names = "--read-noise", paramLabel = "N", defaultValue = "2", description = "Of the camera, in electrons [2].")
	private double readNoise;

	@Option(names = "--bleaching-time", paramLabel = "T", description = "Time in which light fades e-fold, in s [never].")
	private Double bleachingTime;

	@Option(names = "--others", paramLabel = "N", defaultValue = "0", description = "Other filaments that glide through the view [0].")
	private int others;

	@Option(names = "--glide", paramLabel = "N", defaultValue = "1", description = "Their way from frame to frame in pixels [1].")
	private double glide;

	@Option(names = "--debris", paramLabel = "N", defaultValue = "0", description = "Specks that shine [0].")
	private int debris;

	/**
	 * @return how to render
	 * @throws UserException if an option is out of range
	 */
	Rendering rendering() {
		return new Rendering(rendering == Kind.OPTICAL, pixelSize, margin, bits, snr, optics());
	}

	private Optics optics() {
		return new Optics(psfSigma, signal, background, readNoise,
			bleachingTime == null ? Double.POSITIVE_INFINITY : bleachingTime, others, glide,
			debris);
	}
}
