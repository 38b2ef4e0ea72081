
package io.github.knotresolver.progress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

import net.imglib2.img.Img;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.contour.DiscreteFrechet;
import io.github.knotresolver.contour.DynamicTimeWarping;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.RoundSpots;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.mask.ChanVese;
import io.github.knotresolver.measure.DominantFrequency;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.session.Session;
import io.github.knotresolver.skeleton.Skeletonize;

/** Whatever takes long asks, again and again, whether to stop; counted in questions, not in time. */
class CancellationTest {

	/** Says stop from a given question on. */
	private static final class Stop implements Progress {

		private final AtomicInteger questions = new AtomicInteger();
		private final int at;

		Stop(final int at) {
			this.at = at;
		}

		@Override
		public void report(final String stage, final double fraction) {
		}

		@Override
		public boolean isCancelled() {
			return questions.incrementAndGet() > at;
		}
	}

	static Stream<Arguments> loops() {
		final Polyline curve = line(200);
		return Stream.of(
			Arguments.of("warping", 200,
				(Runnable) () -> DynamicTimeWarping.distance(curve, curve)),
			Arguments.of("Fréchet", 200, (Runnable) () -> DiscreteFrechet.distance(curve, curve)),
			Arguments.of("thinning", 10, (Runnable) () -> Skeletonize.thin(block(40))),
			Arguments.of("active contour", 50,
				(Runnable) () -> ChanVese.evolve(ArrayImgs.floats(40, 40), block(40), 50, 0, 0)),
			Arguments.of("still spots", 25,
				(Runnable) () -> RoundSpots.in(spots(5), 100, 1.4, 100)),
			Arguments.of("frequencies", 350, (Runnable) () -> DominantFrequency.of(wave(60), 1)));
	}

	/** One question a round of each loop, in all threads. */
	@ParameterizedTest
	@MethodSource("loops")
	void innerLoopsAskEveryRound(final String name, final int rounds, final Runnable loop) {
		final Stop never = new Stop(Integer.MAX_VALUE);
		Cancellation.during(never, run(loop));
		assertTrue(never.questions.get() >= rounds, name + " asked " + never.questions);
		final Stop early = new Stop(rounds / 2);
		assertThrows(CancelledException.class, () -> Cancellation.during(early, run(loop)));
		assertTrue(early.questions.get() < rounds / 2 + 100, name + " asked " + early.questions);
	}

	/** After the first yes every thread asks once more at most. */
	@ParameterizedTest
	@ValueSource(ints = {0, 10, 300, 3000})
	void aMovieIsGivenUpAtTheNextQuestionOfEveryThread(final int at) {
		final int threads = 2;
		final Movie movie = ImageMovie.of(SampleMovie.open(), InputOptions.DEFAULT);
		final Stop stop = new Stop(at);
		final Settings settings = Settings.DEFAULT.edit().threads(threads).build();
		assertThrows(CancelledException.class,
			() -> new Session(movie, settings).solve(List.of(), stop));
		// Tasks that were waiting ask once before they begin.
		assertTrue(stop.questions.get() <= at + 1 + threads + movie.size(),
			"asked " + stop.questions + " times, cancelled at " + at);
	}

	@Test
	void threadsOfWorkersDoTheWorkOfWhoAsksThem() {
		final Stop stop = new Stop(Integer.MAX_VALUE);
		try (Workers workers = new Workers(2)) {
			Cancellation.during(stop, () -> workers.map(4, i -> {
				assertSame(stop, Cancellation.present());
				return i;
			}));
		}
		assertSame(Progress.NONE, Cancellation.present());
	}

	@Test
	void theListenerBeforeComesBack() {
		final Stop outer = new Stop(9), inner = new Stop(9);
		Cancellation.during(outer, () -> {
			assertThrows(IllegalStateException.class, () -> Cancellation.during(inner, () -> {
				throw new IllegalStateException();
			}));
			assertSame(outer, Cancellation.present());
			return null;
		});
		assertEquals(0, outer.questions.get());
	}

	private static Cancellation.Work<Object, RuntimeException> run(final Runnable loop) {
		return () -> {
			loop.run();
			return null;
		};
	}

	private static Polyline line(final int points) {
		final double[] x = new double[points];
		for (int i = 0; i < points; i++)
			x[i] = i;
		return Polyline.of(x, new double[points]);
	}

	private static double[] wave(final int frames) {
		final double[] values = new double[frames];
		for (int t = 0; t < frames; t++)
			values[t] = Math.sin(0.4 * t) + 0.1 * Math.sin(2.3 * t);
		return values;
	}

	/** So many rows and columns of beads, 20 px apart, as bright as one and a half lines. */
	private static float[] spots(final int rows) {
		final int size = 20 * rows;
		final float[] pixels = new float[size * size];
		for (int i = 0; i < pixels.length; i++) {
			final double x = i % size % 20 - 10, y = i / size % 20 - 10;
			pixels[i] = (float) (150 * Math.exp(-(x * x + y * y) / (2 * 1.7 * 1.7)));
		}
		return pixels;
	}

	private static Img<BitType> block(final int size) {
		final Img<BitType> block = ArrayImgs.bits(size, size);
		block.forEach(BitType::setOne);
		return block;
	}
}
