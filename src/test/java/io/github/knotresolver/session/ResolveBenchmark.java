package io.github.knotresolver.session;

import java.nio.file.Path;
import java.util.List;
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

import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;

/**
 * Guards the promise that a movie of some forty frames of a knotted filament is resolved
 * and fitted in under 1.5 seconds, on two cores, without files and plots. The movie is the
 * sample unless {@code -p movie=FILE} names another.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 5)
@Measurement(iterations = 8)
public class ResolveBenchmark {

	private static final String SAMPLE = "sample";

	/** A movie's file, or the sample. */
	@Param(SAMPLE)
	public String movie;

	private Movie frames;

	/** Opens the movie. */
	@Setup
	public void open() {
		frames = ImageMovie.of(
			movie.equals(SAMPLE) ? SampleMovie.open() : ImageFile.open(Path.of(movie)),
			InputOptions.DEFAULT);
	}

	/** All frames, with nothing told. */
	@Benchmark
	public Tracks resolve() {
		return new Session(frames, Settings.DEFAULT).solve(List.of(), Progress.NONE);
	}
}
