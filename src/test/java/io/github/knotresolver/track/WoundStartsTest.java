package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.image.Pixels;

class WoundStartsTest {

	private static final double LENGTH = 75, RADIUS = 7;

	private static final LineModel LINE = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1);

	private static Chain wound(final double by) {
		return DrawnMovie.winding(by, LENGTH, RADIUS);
	}

	/** Fits to a noisy picture of a chain. */
	private static FilamentFitter fitter(final Chain truth) {
		final DrawnMovie drawn = DrawnMovie.draw(List.of(truth), List.of(), LINE, 0.05, 3);
		final NormalizedFrame frame = new NormalizedFrame(DrawnMovie.SIZE, DrawnMovie.SIZE,
			Pixels.doubles(drawn.movie().frame(0))).rescaled(40, 120);
		return new FilamentFitter(frame, LINE, truth.links(), Optional.of(truth.start()),
			FitSettings.DEFAULT);
	}

	@Test
	void aFilamentThatMovesLittleNeedsNone() {
		assertEquals(List.of(), new WoundStarts(1).of(wound(12), fitter(wound(20))));
	}

	@ParameterizedTest
	@CsvSource({"12, 30", "20, 40", "30, 48", "40, 20", "50, 30"})
	void oneStartIsNearAFilamentThatWindsUpOrUnwindsFast(final double before, final double now) {
		final Chain here = wound(before), truth = wound(now);
		final FilamentFitter fitter = fitter(truth);
		final List<Chain> starts = new WoundStarts(Math.abs(now - before)).of(here, fitter);
		assertTrue(!starts.isEmpty() && starts.size() < 6, starts.size() + " starts");
		final double nearest = starts.stream().mapToDouble(truth::distance).min().orElseThrow();
		assertTrue(nearest < 0.5 * here.distance(truth),
			nearest + " px from the truth; from where it was, " + here.distance(truth));
		final double cheapest = starts.stream()
			.mapToDouble(s -> fitter.fit(s, Optional.empty()).energy()).min().orElseThrow();
		assertTrue(cheapest < fitter.fit(here, Optional.of(here)).energy() + 1e-6,
			"a fit from there is no worse");
	}

	@Test
	void startsDifferFromEachOtherAndKeepLengthAndClamp() {
		final Chain here = wound(20);
		final List<Chain> starts = new WoundStarts(12).of(here, fitter(wound(32)));
		for (int i = 0; i < starts.size(); i++) {
			assertEquals(LENGTH, starts.get(i).length(), 1e-9);
			assertEquals(0, starts.get(i).start().distanceTo(here.start()), 1e-9);
			for (int j = 0; j < i; j++)
				assertTrue(starts.get(i).distance(starts.get(j)) > 1, "starts " + i + ", " + j);
		}
	}
}
