package io.github.knotresolver.imagej.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;

/**
 * A filament that beats with a known frequency: ψ(s, t) = A sin(2π (f t - s/λ))
 * and a slow, random swing of the whole filament, a first-order autoregressive
 * process.
 *
 * @param frequency in Hz
 * @param speed of the wave, µm/s
 */
record Wave(double frequency, double speed) {

	private static final double LENGTH = 6, STEP = 0.05, INTERVAL = 2.5;
	private static final double AMPLITUDE = 0.6, SWING = 0.25, MEMORY = 0.6;

	Trajectory trajectory(final int frames, final long seed) {
		final Random random = new Random(seed);
		final List<Polyline> curves = new ArrayList<>();
		final double start = 2 * Math.PI * random.nextDouble();
		double swing = SWING * random.nextGaussian();
		for (int t = 0; t < frames; t++) {
			curves.add(curve(start + 2 * Math.PI * frequency * t * INTERVAL, swing));
			swing = MEMORY * swing + SWING * Math.sqrt(1 - MEMORY * MEMORY) * random.nextGaussian();
		}
		return new Trajectory(curves, INTERVAL);
	}

	private Polyline curve(final double phase, final double swing) {
		final int n = (int) Math.rint(LENGTH / STEP);
		final double[] x = new double[n + 1], y = new double[n + 1];
		for (int i = 1; i <= n; i++) {
			final double psi = swing
				+ AMPLITUDE * Math.sin(phase - 2 * Math.PI * frequency * (i - 0.5) * STEP / speed);
			x[i] = x[i - 1] + STEP * Math.cos(psi);
			y[i] = y[i - 1] + STEP * Math.sin(psi);
		}
		return Polyline.of(x, y);
	}
}
