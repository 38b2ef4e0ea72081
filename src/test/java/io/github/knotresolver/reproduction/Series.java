package io.github.knotresolver.reproduction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.BitDepth;
import io.github.knotresolver.simulate.Canvas;
import io.github.knotresolver.simulate.FilamentSimulator;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;
import io.github.knotresolver.simulate.PaperRenderer;
import io.github.knotresolver.simulate.SimulatedMovie;
import io.github.knotresolver.simulate.SimulationParameters;

/**
 * One simulated filament of the evaluation: 300 s in 120 frames.
 *
 * @param length in µm
 * @param density motors per µm²
 */
public record Series(int length, int density) {

	/** The published densities, per µm². */
	private static final int[] DENSITIES = {12, 25, 50, 100};
	private static final double PIXEL_SIZE = 0.106;
	private static final int MARGIN = 20;

	/** @return the published range: 5 to 50 µm with four densities each, 24 series */
	static List<Series> published() {
		return all(5, 10, 20, 30, 40, 50);
	}

	/** @return four lengths with two densities each, for a quick look */
	static List<Series> quick() {
		return all(5, 10, 20, 30).stream().filter(s -> s.density == 25 || s.density == 100)
			.toList();
	}

	private static List<Series> all(final int... lengths) {
		final List<Series> series = new ArrayList<>();
		for (final int length : lengths)
			Arrays.stream(DENSITIES).forEach(density -> series.add(new Series(length, density)));
		return series;
	}

	/** @return start of the random numbers */
	private long seed() {
		return 1000L * length + density;
	}

	/** @return the filament's motion */
	Trajectory trajectory() {
		return new FilamentSimulator(SimulationParameters.published(length, density, seed()))
			.run(Progress.NONE);
	}

	/** @return the published rendering of a motion, with noise of {@code snr} dB */
	SimulatedMovie movie(final Trajectory trajectory, final double snr) {
		return SimulatedMovie.render(toString(), trajectory,
			Canvas.around(trajectory, PIXEL_SIZE, MARGIN),
			new PaperRenderer(snr, Math.round(100_000 * snr) + seed()), BitDepth.EIGHT,
			Progress.NONE);
	}

	@Override
	public String toString() {
		return length + " µm, " + density + "/µm²";
	}
}
