
package io.github.knotresolver.simulate;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * What a camera behind a microscope sees: the line integral of a Gaussian point
 * spread function, so that strands that cross are brighter; background and
 * bleaching, other filaments and specks; shot noise and read noise. Grey values
 * are electrons, scaled so that a crossing of two strands with its noise fits
 * into 8 bit; 16 bit has one grey value per electron as long as they fit. Nothing is rounded to
 * whole pixels.
 */
public final class OpticalRenderer implements FrameRenderer {

	private final Optics optics;
	private final Bystanders bystanders;
	private final long seed;

	/**
	 * @param optics microscope, camera and what else is in view
	 * @param seed start of the random numbers
	 */
	public OpticalRenderer(final Optics optics, final long seed) {
		this.optics = optics;
		this.seed = seed;
		bystanders = new Bystanders(optics, seed);
	}

	@Override
	public double[] render(final Polyline curve, final int frame, final Canvas canvas,
		final BitDepth depth) {
		final LightField light = new LightField(canvas.width(), canvas.height(), optics.psfSigma());
		light.addLine(curve, 1);
		bystanders.addTo(light, frame, canvas);
		final double fading = StrictMath
			.exp(-frame * canvas.frameInterval() / optics.bleachingTime());
		final double[] image = light.values();
		final Noise noise = Noise.ofFrame(seed, frame);
		for (int i = 0; i < image.length; i++) {
			final double photons = fading * optics.signal() * image[i] + optics.background();
			image[i] = gain(depth)
				* (noise.poisson(photons) + optics.readNoise() * noise.gaussian());
		}
		return image;
	}

	/** Grey values an electron: two strands and four sigma of noise fit. */
	private double gain(final BitDepth depth) {
		final double brightest = 2 * optics.signal() + optics.background();
		final double noise = Math.sqrt(brightest + optics.readNoise() * optics.readNoise());
		final double fitting = depth.maximum() / (brightest + 4 * noise);
		return depth == BitDepth.EIGHT ? fitting : Math.min(1, fitting);
	}

	/**
	 * What else shines in the view: filaments that glide along wide arcs, and
	 * specks that stay. Random, but the same for a seed and a canvas.
	 */
	static final class Bystanders {

		/** Points on a drawn arc. */
		private static final int POINTS = 60;

		private final Optics optics;
		private final long seed;

		Bystanders(final Optics optics, final long seed) {
			this.optics = optics;
			this.seed = seed;
		}

		/** Adds their light in a frame. */
		void addTo(final LightField light, final int frame, final Canvas canvas) {
			final Noise noise = new Noise(~seed);
			for (int i = 0; i < optics.others(); i++)
				light.addLine(arc(noise, canvas, frame * optics.glide()),
					0.6 + 0.4 * noise.uniform());
			for (int i = 0; i < optics.debris(); i++)
				light.addSpot(place(noise, canvas), 0.5 + noise.uniform());
		}

		private static Point place(final Noise noise, final Canvas canvas) {
			return new Point(noise.uniform() * canvas.width(), noise.uniform() * canvas.height());
		}

		/** An arc through a random place, moved along itself by {@code way}. */
		private static Polyline arc(final Noise noise, final Canvas canvas, final double way) {
			final double size = Math.min(canvas.width(), canvas.height());
			final double length = size * (0.3 + 0.7 * noise.uniform());
			final double radius = size * (1 + 2 * noise.uniform())
				* (noise.uniform() < 0.5 ? -1 : 1);
			final double heading = 2 * Math.PI * noise.uniform();
			final Point start = place(noise, canvas);
			final double[] x = new double[POINTS], y = new double[POINTS];
			for (int i = 0; i < POINTS; i++) {
				final double turn = heading + (way + length * i / (POINTS - 1)) / radius;
				x[i] = start.x() + radius * (StrictMath.sin(turn) - StrictMath.sin(heading));
				y[i] = start.y() - radius * (StrictMath.cos(turn) - StrictMath.cos(heading));
			}
			return Polyline.of(x, y);
		}
	}
}
