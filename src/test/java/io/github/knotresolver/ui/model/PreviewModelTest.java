package io.github.knotresolver.ui.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.MovieSource;
import io.github.knotresolver.session.FrameLook;

/** What a preview says and shows, without any window. */
class PreviewModelTest {

	private final PreviewModel model = new PreviewModel();
	private final MovieSource sample = ImageSource.of(SampleMovie.open());

	@AfterEach
	void close() {
		model.close();
	}

	private Optional<FrameLook> ask(final MovieSource source, final Map<String, String> texts,
		final int frame) throws InterruptedException {
		model.ask(new PreviewModel.Question(source, RunOptions.parse(texts), frame));
		return model.atRest();
	}

	@Test
	void oneLineSaysWhatWasFoundInTheFrame() throws Exception {
		assertEquals(1, ask(sample, Map.of(), 1).orElseThrow().frame());
		assertTrue(
			model.line().matches(
				"frame 1: 1 filament, width 3\\.\\d px, bright on dark, 14\\.\\d µm, ends clear"),
			model.line());
		// The check has found the fixed end, so the knot is one filament, too.
		ask(sample, Map.of(), 13);
		assertTrue(model.line().startsWith("frame 13: 1 filament, "), model.line());
		assertTrue(model.checks().isEmpty(), model.checks().toString());
	}

	@Test
	void valuesChangeWhatIsSeen() throws Exception {
		final int automatic = ask(sample, Map.of(), 1).orElseThrow().area();
		final FrameLook low = ask(sample, Map.of("threshold", "0.2", "iterations", "0"), 1)
			.orElseThrow();
		assertTrue(low.area() > automatic, low.area() + " <= " + automatic);
		assertTrue(low.width().isEmpty());
		assertEquals(automatic, ask(sample, Map.of(), 1).orElseThrow().area());
		ask(sample, Map.of("polarity", "dark"), 1);
		assertTrue(model.checks().get(0).startsWith("Polarity: dark lines"),
			model.checks().toString());
	}

	@Test
	void whatCannotBeShownIsSaidInOneSentence() throws Exception {
		assertTrue(ask(sample, Map.of("frames", "1-99"), 1).isEmpty());
		assertEquals("frames names frame 99, but the movie has 24 frames.", model.line());
		final MovieSource broken = new MovieSource() {

			@Override
			public Movie read(final InputOptions options, final Progress progress) {
				throw new UserException("It is gone.");
			}

			@Override
			public Optional<Path> file() {
				return Optional.empty();
			}
		};
		assertTrue(ask(broken, Map.of(), 1).isEmpty());
		assertEquals("It is gone.", model.line());
		assertTrue(ask(sample, Map.of(), 2).isPresent());
	}

	@Test
	void theLastQuestionWinsAndOffForgetsAll() throws Exception {
		for (int frame = 1; frame <= 24; frame++)
			model.ask(new PreviewModel.Question(sample, RunOptions.parse(Map.of()), frame));
		assertEquals(24, model.atRest().orElseThrow().frame());
		assertFalse(model.isWorking());
		model.off();
		assertTrue(model.look().isEmpty() && model.line().isEmpty() && model.checks().isEmpty());
		assertTrue(ask(sample, Map.of(), 3).isPresent());
	}

	@Test
	void theMovieIsReadOnceAndTheSameQuestionIsAskedOnce() throws Exception {
		final AtomicInteger reads = new AtomicInteger(), told = new AtomicInteger();
		final MovieSource counted = new MovieSource() {

			@Override
			public Movie read(final InputOptions options, final Progress progress) {
				reads.incrementAndGet();
				return sample.read(options, progress);
			}

			@Override
			public Optional<Path> file() {
				return Optional.empty();
			}
		};
		ask(counted, Map.of(), 1);
		ask(counted, Map.of("threshold", "0.4"), 2);
		assertEquals(1, reads.get());
		// The thread that answered may still be telling of it.
		final Thread caller = Thread.currentThread();
		model.listen(() -> {
			if (Thread.currentThread() == caller)
				told.incrementAndGet();
		});
		ask(counted, Map.of("threshold", "0.4"), 2);
		assertEquals(0, told.get());
	}

	@Test
	void closingInTheMiddleStops() throws Exception {
		final CountDownLatch reading = new CountDownLatch(1), goOn = new CountDownLatch(1);
		final MovieSource slow = new MovieSource() {

			@Override
			public Movie read(final InputOptions options, final Progress progress) {
				reading.countDown();
				try {
					goOn.await();
				} catch (final InterruptedException e) {
					throw new IllegalStateException(e);
				}
				return sample.read(options, progress);
			}

			@Override
			public Optional<Path> file() {
				return Optional.empty();
			}
		};
		model.ask(new PreviewModel.Question(slow, RunOptions.parse(Map.of()), 1));
		reading.await();
		model.close();
		goOn.countDown();
		assertTrue(model.atRest().isEmpty());
		model.ask(new PreviewModel.Question(sample, RunOptions.parse(Map.of()), 1));
		assertTrue(model.look().isEmpty());
	}
}
