package io.github.knotresolver.imagej.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.infra.Blackhole;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.model.Calibration;

/**
 * Guards the promise that 1000 frames of 500 points are measured and plotted in
 * under two seconds.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class MeasureBenchmark {

	private static final int FRAMES = 1000, POINTS = 500;

	private final List<Optional<Polyline>> contours = new ArrayList<>();

	/** A beating filament. */
	@Setup
	public void swing() {
		for (int f = 0; f < FRAMES; f++) {
			final double[] x = new double[POINTS], y = new double[POINTS];
			for (int i = 1; i < POINTS; i++) {
				final double psi = 0.8 * Math.sin(i / 60.0 - f / 9.0);
				x[i] = x[i - 1] + Math.cos(psi);
				y[i] = y[i - 1] + Math.sin(psi) + 0.05 * Math.sin(17.0 * i * f);
			}
			contours.add(Optional.of(Polyline.of(x, y)));
		}
	}

	/** Measures only. */
	@Benchmark
	public MovieMeasurements measure() {
		return MovieMeasurements.of("swing", contours, new Calibration(0.1, "µm", 1, "s"));
	}

	/** Measures and draws every chart. */
	@Benchmark
	public void measureAndPlot(final Blackhole hole) {
		System.setProperty("java.awt.headless", "true");
		Figures.charts(measure()).values()
			.forEach(chart -> hole.consume(chart.createBufferedImage(900, 600)));
	}
}
