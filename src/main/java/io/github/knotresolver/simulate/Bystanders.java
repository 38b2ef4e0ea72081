
package io.github.knotresolver.simulate;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * What else shines in the view: filaments that glide along wide arcs, and
 * specks that stay. Random, but the same for a seed and a canvas.
 */
final class Bystanders {

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
			light.addLine(arc(noise, canvas, frame * optics.glide()), 0.6 + 0.4 * noise.uniform());
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
		final double radius = size * (1 + 2 * noise.uniform()) * (noise.uniform() < 0.5 ? -1 : 1);
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
