package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.CancelledProgress;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

class PropagationTest {

	private static final LineModel LINE = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1);

	private static final int FRAMES = 8;

	private final List<Chain> truth = DrawnMovie.waves(FRAMES, 90, 3.2);

	private final List<FrameView> frames = DrawnFrames.of(truth, LINE, t -> 1);

	private FilamentFitter fitter(final int t) {
		return new FilamentFitter(frames.get(t).light().rescaled(0, 120), LINE,
			truth.get(t).links(), Optional.of(truth.get(0).start()), FitSettings.DEFAULT);
	}

	/** Nothing is proposed but one fit, in one frame. */
	private List<List<Fit>> proposedIn(final int frame) {
		final List<List<Fit>> proposals = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			proposals.add(
				t == frame ? List.of(fitter(t).fit(truth.get(t), Optional.empty())) : List.of());
		return proposals;
	}

	private Propagation.Frames frames() {
		final FilamentEstimate estimate = new FilamentEstimate(LINE, 120, 90, 0.1,
			truth.get(0).start(), false);
		return new Propagation.Frames(
			new FilamentCourse(estimate, AnchorPath.still(truth.get(0).start(), FRAMES),
				LengthCourse.constant(90, FRAMES), 0, 0.9),
			false);
	}

	private List<List<Fit>> walk(final int seen, final int[] order) {
		return new Propagation(3, new MotionPrice(3, 0.1), this::fitter, proposedIn(seen), frames(),
			Progress.NONE).walk(order);
	}

	private void assertFollows(final Chain chain, final List<Fit> fits, final String frame) {
		final Chain best = fits.stream().min(Comparator.comparingDouble(Fit::energy)).orElseThrow()
			.chain();
		assertTrue(best.distance(chain) < 1, frame + ": " + best.distance(chain) + " px off");
	}

	@Test
	void oneProposalIsCarriedThroughTheMovieForwards() {
		final List<List<Fit>> fits = walk(0, IntStream.range(0, FRAMES).toArray());
		assertEquals(List.of(), fits.get(0), "nothing came before");
		for (int t = 1; t < FRAMES; t++)
			assertFollows(truth.get(t), fits.get(t), "frame " + t);
	}

	@Test
	void andBackwards() {
		final List<List<Fit>> fits = walk(FRAMES - 1,
			IntStream.range(0, FRAMES).map(i -> FRAMES - 1 - i).toArray());
		for (int i = 1; i < FRAMES; i++)
			assertFollows(truth.get(FRAMES - 1 - i), fits.get(i), "frame " + (FRAMES - 1 - i));
	}

	@Test
	void whatIsNewSpreadsUntilItIsKnown() {
		final int from = 1, met = 4;
		final List<List<Fit>> known = IntStream.range(0, FRAMES).mapToObj(
			t -> t == met ? List.of(fitter(t).fit(truth.get(t), Optional.empty())) : List.<Fit>of())
			.toList();
		final Propagation propagation = new Propagation(3, new MotionPrice(3, 0.1), this::fitter,
			known, frames(), Progress.NONE);
		final List<Fit> fits = List.of(fitter(from).fit(truth.get(from), Optional.empty()));
		final SortedMap<Integer, List<Fit>> forwards = propagation.spread(from, 1, fits, known);
		assertEquals(Set.of(2, 3), forwards.keySet());
		forwards.forEach((t, found) -> assertFollows(truth.get(t), found, "frame " + t));
		assertEquals(Set.of(0), propagation.spread(from, -1, fits, known).keySet());
	}

	@Test
	void cancelStopsIt() {
		final Propagation propagation = new Propagation(3, new MotionPrice(3, 0.1), this::fitter,
			proposedIn(0), frames(), new CancelledProgress());
		assertThrows(CancelledException.class, () -> propagation.walk(new int[]{0, 1}));
	}
}
