package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.ResolveRun;
import io.github.knotresolver.session.Engine;

/** Movies side by side. */
class BatchTest {

	@TempDir
	Path home;
	private final List<BatchRow> rows = new ArrayList<>();
	private final List<String> told = new ArrayList<>();

	@BeforeEach
	void saveMovies() {
		System.setProperty("java.awt.headless", "true");
		for (int i = 0; i < 4; i++)
			add(TestImages.save(TestImages.movie(3 + i % 2, 8), home.resolve("m" + i + ".tif")));
	}

	@Test
	void sideBySideGivesTheSameBytesAsOneByOne() throws IOException {
		rows.remove(0);
		for (final BatchRow row : rows) {
			final ResolveRun run = ResolveRun.of(Map.of("threads", "1"));
			final ImageSource source = ImageSource.of(row.file());
			try (ResultFolder folder = ResultFolder.reserve(
				home.resolve("single").resolve(row.name().replace(".tif", "")),
				ResultKind.RESOLVED_MOVIE, false, List.of())) {
				run.read(source, Progress.NONE).resolve(Engine.PIPELINE,
					new FolderSink(folder, source, false), Progress.NONE);
			}
		}
		final Map<String, List<Byte>> single = bytes(home.resolve("single"));
		assertTrue(single.keySet().contains("m3/contours.csv"), single.keySet().toString());
		// Two threads each, and all four for the last one.
		run(Engine.PIPELINE, "4", Optional.of(2), false, "out");
		assertEquals(single, bytes(home.resolve("out")));
	}

	@Test
	void moviesRunAtTheSameTimeAndTheListKeepsTheirOrder() throws IOException {
		final CountDownLatch all = new CountDownLatch(4);
		final AtomicInteger threads = new AtomicInteger();
		final List<BatchOutcome> outcomes = run((movie, settings, progress) -> {
			threads.accumulateAndGet(settings.threads(), Math::max);
			all.countDown();
			await(all);
			return TestImages.resolve(movie, settings, progress);
		}, "4", Optional.empty(), false, "out");
		assertEquals(0, all.getCount());
		assertEquals(1, threads.get());
		assertEquals(List.of("m0", "m1", "m2", "m3"),
			outcomes.stream().map(o -> o.folder().get()).toList());
		final List<String> list = Files.readAllLines(home.resolve("out/batch.csv"));
		assertTrue(list.get(1).startsWith("1,") && list.get(4).startsWith("4,"), list.toString());
		assertEquals(4, told.size());
	}

	@Test
	void oneAtATimeHasAllThreads() throws IOException {
		final AtomicInteger running = new AtomicInteger(), most = new AtomicInteger();
		final List<Integer> threads = new ArrayList<>();
		run((movie, settings, progress) -> {
			most.accumulateAndGet(running.incrementAndGet(), Math::max);
			threads.add(settings.threads());
			running.decrementAndGet();
			return TestImages.resolve(movie, settings, progress);
		}, "6", Optional.of(1), false, "out");
		assertEquals(1, most.get());
		assertEquals(List.of(6, 6, 6, 6), threads);
	}

	@Test
	void tooLittleMemoryBesideOthersIsTriedAgainAloneAndStopsNothing() throws IOException {
		final AtomicInteger tries = new AtomicInteger();
		final List<BatchOutcome> outcomes = run((movie, settings, progress) -> {
			if (movie.name().equals("m1.tif") && tries.incrementAndGet() == 1)
				throw new OutOfMemoryError("Java heap space");
			if (movie.name().equals("m2.tif"))
				throw new OutOfMemoryError("Java heap space");
			return TestImages.resolve(movie, settings, progress);
		}, "2", Optional.empty(), false, "out");
		assertEquals(List.of(Status.FINISHED, Status.FINISHED, Status.FAILED, Status.FINISHED),
			outcomes.stream().map(BatchOutcome::status).toList());
		assertEquals(2, tries.get());
		assertEquals("There is not enough memory for this movie; give Java more.",
			outcomes.get(2).message());
		assertEquals(List.of("batch.csv", "batch.html", "m0", "m1", "m3"),
			names(home.resolve("out")));
	}

	@Test
	void whatNobodyForesawStopsNothing() throws IOException {
		final List<BatchOutcome> outcomes = run((movie, settings, progress) -> {
			if (movie.name().equals("m0.tif"))
				throw new StackOverflowError();
			if (movie.name().equals("m2.tif"))
				throw new IllegalStateException("odd");
			return TestImages.resolve(movie, settings, progress);
		}, "3", Optional.empty(), false, "out");
		assertEquals(List.of(Status.FAILED, Status.FINISHED, Status.FAILED, Status.FINISHED),
			outcomes.stream().map(BatchOutcome::status).toList());
		assertTrue(outcomes.get(2).message().startsWith("This is a bug in KnotResolver"),
			outcomes.get(2).message());
	}

	@Test
	void memoryIsToldFromTheFile() throws IOException {
		final long small = MovieMemory.of(home.resolve("m0.tif")),
			large = MovieMemory.of(home.resolve("m1.tif"));
		assertEquals(large - small, 16L * TestImages.WIDTH * TestImages.HEIGHT);
		final Path folder = Files.createDirectory(home.resolve("frames"));
		Files.write(folder.resolve("1.png"), new byte[1000]);
		assertEquals(16L * 8000, MovieMemory.of(folder) - MovieMemory.of(home.resolve("absent")));
		assertThrows(UserException.class,
			() -> new Batch(Engine.PIPELINE, Map.of(), false, false, Optional.of(0)));
	}

	private void add(final Path movie) {
		rows.add(new BatchRow(rows.size() + 1, movie.toString(), Map.of(), List.of()));
	}

	private List<BatchOutcome> run(final Engine engine, final String threads,
		final Optional<Integer> movies, final boolean plots, final String out) throws IOException {
		return new Batch(engine, Map.of("threads", threads), false, plots, movies).run(
			new BatchWork(rows, home.resolve(out), List.of()), o -> told.add(o.line()),
			Progress.NONE);
	}

	private static void await(final CountDownLatch latch) {
		try {
			assertTrue(latch.await(60, TimeUnit.SECONDS), "not all run at the same time");
		} catch (final InterruptedException e) {
			throw new IllegalStateException(e);
		}
	}

	/** All files of the result folders. */
	private static Map<String, List<Byte>> bytes(final Path out) throws IOException {
		final Map<String, List<Byte>> all = new TreeMap<>();
		try (Stream<Path> files = Files.walk(out)) {
			for (final Path file : files.filter(Files::isRegularFile)
				.filter(f -> !f.getParent().equals(out)).toList()) {
				final List<Byte> bytes = new ArrayList<>();
				for (final byte b : Files.readAllBytes(file))
					bytes.add(b);
				all.put(out.relativize(file).toString().replace('\\', '/'), bytes);
			}
		}
		return all;
	}

	private static List<String> names(final Path folder) throws IOException {
		try (Stream<Path> files = Files.list(folder)) {
			return files.map(f -> f.getFileName().toString()).sorted().toList();
		}
	}
}
