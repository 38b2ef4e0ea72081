package io.github.knotresolver.imagej.accuracy;

import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.BitDepth;
import io.github.knotresolver.simulate.Canvas;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;
import io.github.knotresolver.simulate.FrameRenderer;
import io.github.knotresolver.simulate.OpticalRenderer;
import io.github.knotresolver.simulate.Optics;
import io.github.knotresolver.simulate.PaperRenderer;
import io.github.knotresolver.simulate.SimulatedMovie;

/**
 * How trajectories are drawn. The optical ones have about the noise of the
 * published ones: with 100 photons about 10 dB, with 400 about 20 dB.
 */
enum Pictures {
	PAPER_10("published rendering, 10 dB") {
		@Override
		FrameRenderer renderer(final long seed) {
			return new PaperRenderer(10, seed);
		}
	},
	PAPER_20("published rendering, 20 dB") {
		@Override
		FrameRenderer renderer(final long seed) {
			return new PaperRenderer(20, seed);
		}
	},
	OPTICAL_100("microscope, 100 photons") {
		@Override
		FrameRenderer renderer(final long seed) {
			return new OpticalRenderer(Optics.CLEAN, seed);
		}
	},
	OPTICAL_400("microscope, 400 photons") {
		@Override
		FrameRenderer renderer(final long seed) {
			return new OpticalRenderer(
				new Optics(1.5, 400, 20, 2, Double.POSITIVE_INFINITY, 0, 1, 0), seed);
		}
	};

	private static final double PIXEL = 0.106;
	private static final int MARGIN = 20;

	private final String label;

	Pictures(final String label) {
		this.label = label;
	}

	abstract FrameRenderer renderer(long seed);

	String label() {
		return label;
	}

	SimulatedMovie movie(final Trajectory trajectory, final long seed) {
		return SimulatedMovie.render(name(), trajectory, Canvas.around(trajectory, PIXEL, MARGIN),
			renderer(seed), BitDepth.SIXTEEN, Progress.NONE);
	}
}
