
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings.AnchorChoice;

class FilamentEndsTest {

	private static Chain rod(final double x, final double y, final double angle) {
		return Chain.inScene(Polyline.of(new double[]{x, x + 40 * Math.cos(angle)},
			new double[]{y, y + 40 * Math.sin(angle)}), 40);
	}

	@Test
	void aGliderRunsFromItsTrailingToItsLeadingEnd() {
		final List<Chain> chains = new ArrayList<>();
		for (int t = 0; t < 10; t++)
			chains.add(rod(20 + 2 * t, 50, 0));
		final FilamentEnds ends = FilamentEnds.of(chains, AnchorChoice.AUTO);
		assertFalse(ends.clamped());
		assertFalse(ends.reversed());
		assertEquals(18, ends.slid(), 1e-9);
		assertTrue(FilamentEnds.of(chains.stream().map(Chain::reversed).toList(), AnchorChoice.AUTO)
			.reversed());
	}

	@Test
	void whatHappensWhileAFilamentIsLostDoesNotDecide() {
		final List<Chain> chains = new ArrayList<>();
		final boolean[] clear = new boolean[40];
		for (int t = 0; t < 40; t++) {
			clear[t] = t < 15 && t != 7;
			chains.add(t < 15 ? rod(20 + 2 * t, 50, 0) : rod(50 - 3 * (t - 15), 50, 0.3));
		}
		assertTrue(FilamentEnds.of(chains, AnchorChoice.AUTO).reversed());
		final FilamentEnds ends = FilamentEnds.of(chains, clear, AnchorChoice.AUTO);
		assertFalse(ends.reversed());
		assertEquals(28, ends.slid(), 1e-9);
		assertFalse(ends.roams(), "in the median, both ends are 7 px from their place");
		assertFalse(FilamentEnds.of(chains, new boolean[40], AnchorChoice.AUTO).roams());
	}

	@Test
	void theEndThatStaysComesFirstAlsoIfTheStageDrifts() {
		final List<Chain> chains = new ArrayList<>();
		for (int t = 0; t < 30; t++)
			chains.add(rod(50 + 0.4 * t, 50, 1.2 * Math.sin(t)).reversed());
		final FilamentEnds ends = FilamentEnds.of(chains, AnchorChoice.AUTO);
		assertTrue(ends.clamped());
		assertTrue(ends.reversed());
		assertFalse(FilamentEnds.of(chains, AnchorChoice.FREE).clamped());
	}

	/** In noise, of a filament that a motor buckles: its tip is drawn towards the clamp. */
	@Test
	void anEndThatStaysIsClampedThoughNoiseMovesIt() {
		final List<Chain> chains = new ArrayList<>();
		for (int t = 0; t < 5; t++) {
			final double y = t % 2 == 0 ? 50 : 51;
			chains.add(Chain.inScene(Polyline.of(new double[]{20, 30 - t, 40, 160 - 13 * t},
				new double[]{y, 50 - 6 * t, 50, 50}), 160));
		}
		final FilamentEnds ends = FilamentEnds.of(chains, AnchorChoice.AUTO);
		assertTrue(ends.clamped());
		assertFalse(ends.reversed());
	}

	/** Its tip is drawn in by less from frame to frame than noise moves either end. */
	@Test
	void anEndThatStaysIsClampedThoughTheOtherOneIsSlow() {
		final Random random = new Random(6);
		final List<Chain> chains = new ArrayList<>();
		for (int t = 0; t < 40; t++)
			chains
				.add(
					Chain
						.inScene(
							Polyline.of(
								new double[]{20 + 0.6 * random.nextGaussian(), 30 - 0.2 * t, 40,
									160 - 0.8 * t + 0.6 * random.nextGaussian()},
								new double[]{50 + 0.6 * random.nextGaussian(), 50 - t, 50, 50}),
							160));
		final FilamentEnds ends = FilamentEnds.of(chains, AnchorChoice.AUTO);
		assertTrue(ends.clamped());
		assertFalse(ends.reversed());
	}

	@Test
	void ofABeatingFilamentThatIsCarriedTheEndThatMovesLessComesFirst() {
		final List<Chain> chains = new ArrayList<>();
		for (int t = 0; t < 40; t++)
			chains.add(rod(150 - 2 * t, 50 + 10 * Math.sin(0.1 * t), 0.5 * Math.sin(0.4 * t)));
		final FilamentEnds ends = FilamentEnds.of(chains, AnchorChoice.AUTO);
		assertFalse(ends.clamped());
		assertTrue(ends.slid() > 60, "it is carried towards its first end");
		assertFalse(ends.reversed());
		assertTrue(FilamentEnds.of(chains.stream().map(Chain::reversed).toList(), AnchorChoice.AUTO)
			.reversed());
	}

	@Test
	void aGliderOnABentTrackKeepsItsDirectionThoughItsTrailingEndMovesMore() {
		final List<Chain> chains = new ArrayList<>();
		for (int t = 0; t < 30; t++)
			chains.add(onRing(0.05 * t));
		assertFalse(FilamentEnds.of(chains, AnchorChoice.AUTO).reversed());
		assertTrue(FilamentEnds.of(chains.stream().map(Chain::reversed).toList(), AnchorChoice.AUTO)
			.reversed());
	}

	/** A part of a ring whose trailing end sways. */
	private static Chain onRing(final double from) {
		final double[] x = new double[41], y = new double[41];
		for (int i = 0; i <= 40; i++) {
			final double r = 40 + (i < 5 ? (5 - i) * 0.3 * Math.cos(60 * from) : 0);
			x[i] = 60 + r * Math.cos(from + 0.03 * i);
			y[i] = 60 + r * Math.sin(from + 0.03 * i);
		}
		return Chain.inScene(Polyline.of(x, y), 48);
	}

	@Test
	void whichEndComesFirstIsInDoubtWhereBothMoveAlike() {
		final List<Chain> carried = new ArrayList<>(), gliding = new ArrayList<>();
		for (int t = 0; t < 20; t++) {
			carried.add(rod(30 + t, 40 + 3 * Math.sin(0.5 * t), 1));
			gliding.add(rod(30 + t, 40, 0));
		}
		final List<Observation> frames = List.of(new Observation(1, FrameStatus.RESOLVED, "",
			Optional.of(carried.get(0).contour()), 0, 1, 0, 1));
		final FilamentEnds doubtful = FilamentEnds.of(carried, AnchorChoice.AUTO);
		assertTrue(doubtful.alike());
		assertEquals(0.5, doubtful.doubted(frames).get(0).confidence());
		final FilamentEnds sure = FilamentEnds.of(gliding, AnchorChoice.AUTO);
		assertFalse(sure.alike());
		assertEquals(frames, sure.doubted(frames));
	}
}
