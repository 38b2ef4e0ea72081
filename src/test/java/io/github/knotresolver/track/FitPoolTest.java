package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;

class FitPoolTest {

	private static Fit line(final double y, final double energy) {
		return new Fit(Chain.along(Drawn.line(0, y, 50, y), 10, 50), 0, energy, 1);
	}

	@Test
	void ofFitsThatAreNearlyTheSameTheCheaperStays() {
		final FitPool pool = new FitPool();
		final Fit first = line(0, 5), dearer = line(0.5, 6), cheaper = line(0.4, 4);
		assertSame(first, pool.add(first));
		assertSame(first, pool.add(dearer));
		assertEquals(List.of(first), pool.fits());
		assertSame(cheaper, pool.add(cheaper));
		assertEquals(List.of(cheaper), pool.fits());
	}

	@Test
	void thoseThatAreInItToBeginWithAreKeptHoweverNear() {
		final Fit first = line(0, 5), near = line(0.5, 6);
		final FitPool pool = new FitPool(List.of(first, near));
		assertSame(first, pool.add(line(0.1, 7)));
		assertEquals(List.of(first, near), pool.fits());
	}

	@Test
	void fitsThatDifferAreKeptInTheirOrder() {
		final FitPool pool = new FitPool();
		final Fit first = line(0, 5), second = line(3, 1), third = line(-3, 9);
		pool.add(first);
		assertSame(second, pool.add(second));
		assertSame(third, pool.add(third));
		assertEquals(List.of(first, second, third), pool.fits());
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5})
	void noTwoFitsThatStayAreTheSameAndTheCheapestIsAmongThem(final long seed) {
		final Random random = new Random(seed);
		final FitPool pool = new FitPool();
		double cheapest = Double.POSITIVE_INFINITY;
		for (int i = 0; i < 60; i++) {
			final Fit fit = line(12 * random.nextDouble(), random.nextDouble());
			cheapest = Math.min(cheapest, fit.energy());
			pool.add(fit);
		}
		assertEquals(cheapest, pool.fits().stream().mapToDouble(Fit::energy).min().orElseThrow(),
			"seed " + seed);
		assertTrue(pool.fits().size() > 3 && pool.fits().size() < 30,
			"seed " + seed + ": " + pool.fits().size());
	}
}
