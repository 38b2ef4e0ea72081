package io.github.knotresolver.simulate;

/**
 * How a microscope and its camera see the filament, and what else is in view.
 *
 * @param psfSigma width of the Gaussian point spread function in pixels, 0.3 to
 *          20; default 1.5
 * @param signal photons in a pixel on the middle of a straight filament, 0.1 to
 *          1e6; default 100
 * @param background photons in a pixel without a filament, 0 to 1e6; default 20
 * @param readNoise standard deviation of the camera's noise in electrons, 0 to
 *          1000; default 2
 * @param bleachingTime time in s in which light fades e-fold, above 0; infinity
 *          (the default) for never
 * @param others other filaments that glide through the view, 0 to 100; default
 *          0
 * @param glide their way from frame to frame in pixels, 0 to 1000; default 1
 * @param debris specks of dirt that shine, 0 to 1000; default 0
 */
public record Optics(double psfSigma, double signal, double background, double readNoise,
	double bleachingTime, int others, double glide, int debris) {

	/** A clean preparation, well exposed. */
	public static final Optics CLEAN = new Optics(1.5, 100, 20, 2, Double.POSITIVE_INFINITY, 0, 1,
		0);

	public Optics {
		Require.within("psf_sigma", psfSigma, 0.3, 20, "pixels");
		Require.within("signal", signal, 0.1, 1e6, "photons");
		Require.within("background", background, 0, 1e6, "photons");
		Require.within("read_noise", readNoise, 0, 1000, "electrons");
		if (bleachingTime != Double.POSITIVE_INFINITY)
			Require.within("bleaching_time", bleachingTime, 1e-3, 1e9, "s");
		Require.within("others", others, 0, 100);
		Require.within("glide", glide, 0, 1000, "pixels per frame");
		Require.within("debris", debris, 0, 1000);
	}
}
