package io.github.knotresolver.evaluate.like;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.evaluate.Evaluation;

/**
 * One simulated movie, resolved and scored.
 *
 * @param seed that it was simulated with
 * @param evaluation the scores of its frames
 * @param knotted for every frame, whether the filament meets or crosses itself
 * @param confidence for every frame, how sure the program was; NaN without a
 *          contour
 * @param traits what it looks like and how it moves
 * @param refusal why nothing was resolved, in one sentence; empty if it was
 */
public record LikeMovie(long seed, Evaluation evaluation, List<Boolean> knotted,
	List<Double> confidence, LikeTraits traits, Optional<String> refusal) {

	public LikeMovie {
		knotted = List.copyOf(knotted);
		confidence = List.copyOf(confidence);
	}

	/** @return number of frames that are resolved */
	public int resolved() {
		return count(false, true);
	}

	/** @return number of frames in which the filament meets or crosses itself */
	public int knottedFrames() {
		return count(true, false);
	}

	/** @return of these, the number that are resolved */
	public int knottedResolved() {
		return count(true, true);
	}

	private int count(final boolean onlyKnotted, final boolean onlyResolved) {
		int count = 0;
		for (int i = 0; i < knotted.size(); i++)
			if ((!onlyKnotted || knotted.get(i))
				&& (!onlyResolved || evaluation.frames().get(i).score().isResolved()))
				count++;
		return count;
	}
}
