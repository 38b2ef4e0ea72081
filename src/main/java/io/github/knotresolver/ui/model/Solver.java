package io.github.knotresolver.ui.model;

import java.util.List;

import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;

/**
 * What answers a person: {@link io.github.knotresolver.session.Session#solve}. It is asked by one
 * thread at a time.
 */
@FunctionalInterface
public interface Solver {

	/**
	 * @param said all that a person says about frames
	 * @param progress told how far the work is, and asked whether to stop
	 * @return the whole movie, resolved
	 * @throws io.github.knotresolver.model.UserException if that cannot be followed, in one sentence
	 * @throws io.github.knotresolver.progress.CancelledException if it was asked to stop
	 */
	Tracks solve(List<Constraint> said, Progress progress);
}
