package io.github.knotresolver.fit;

import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Guards the promise that the fit of one frame takes at most 5 ms for a filament of 200
 * pixels, on one core, and grows linearly with its length: a wave in noise, started from
 * where it was a frame before.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 4, time = 1)
@Measurement(iterations = 6, time = 1)
public class FitBenchmark {

	private static final int HEIGHT = 120;
	private static final double NOISE = 0.15, LINK = 3, WAVELENGTH = 60, TRAVELLED = 1.5;

	/** Length of the filament in pixels. */
	@Param({"200", "400", "800"})
	public int length;

	/** How strands add up. */
	@Param({"SATURATING", "ADDITIVE"})
	public String kind;

	private FilamentFitter fitter;
	private Chain start;

	/** Draws the frame. */
	@Setup
	public void draw() {
		final LineModel.Kind strands = LineModel.Kind.valueOf(kind);
		final LineModel model = LineModel.uniform(strands, 1.6,
			strands == LineModel.Kind.ADDITIVE ? 1 : 1.5);
		final int links = FilamentEstimator.links(length);
		final Chain truth = wave(links, 0);
		final double[] x = new double[links + 1], y = new double[links + 1];
		truth.nodes(x, y);
		final double[] pixels = new double[length * HEIGHT];
		ImageTerm.of(new NormalizedFrame(length, HEIGHT, pixels), model, links).draw(x, y, links,
			new Patch(0, 0, length, HEIGHT), pixels);
		final Random random = new Random(1);
		for (int i = 0; i < pixels.length; i++)
			pixels[i] += NOISE * random.nextGaussian();
		fitter = new FilamentFitter(new NormalizedFrame(length, HEIGHT, pixels), model, links,
			Optional.of(truth.start()), FitSettings.DEFAULT);
		start = wave(links, TRAVELLED);
	}

	/** One frame. */
	@Benchmark
	public Fit fit() {
		return fitter.fit(start, Optional.of(start));
	}

	/** A wave as in a beating filament, a little farther on. */
	private static Chain wave(final int links, final double travelled) {
		final double[] theta = new double[links];
		for (int i = 0; i < links; i++)
			theta[i] = 1.2 * Math.sin(2 * Math.PI * (LINK * i - travelled) / WAVELENGTH);
		return new Chain(20, HEIGHT / 2.0, theta, LINK);
	}
}
