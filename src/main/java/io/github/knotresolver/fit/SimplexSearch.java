
package io.github.knotresolver.fit;

import java.util.function.ToDoubleFunction;

import org.apache.commons.math3.exception.TooManyEvaluationsException;
import org.apache.commons.math3.optim.InitialGuess;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.nonlinear.scalar.ObjectiveFunction;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.NelderMeadSimplex;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.SimplexOptimizer;

import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/**
 * Where a function of few variables is lowest, by the simplex search of Nelder and Mead (1965,
 * doi:10.1093/comjnl/7.4.308), within a bounded number of evaluations. A search that has not
 * settled by then gives the lowest point that it has seen: a function that falls without end, or is
 * nowhere defined, is no failure of the program. Progress is asked before every evaluation.
 *
 * @param relative change of the value below which the search has settled, relative
 * @param absolute likewise, absolute
 * @param evaluations how often the function may be evaluated, at least 1
 * @param progress may cancel
 */
public record SimplexSearch(double relative, double absolute, int evaluations, Progress progress) {

	/**
	 * @param function what is to be low; NaN where it is not defined
	 * @param guess where to begin
	 * @param spread how far the first simplex reaches from there in every variable, not 0
	 * @return the lowest point; the guess if the function is not defined anywhere
	 * @throws CancelledException if the user asked to stop
	 */
	public double[] lowest(final ToDoubleFunction<double[]> function, final double[] guess,
		final double[] spread) {
		final Lowest seen = new Lowest(function, progress, guess);
		try {
			return new SimplexOptimizer(relative, absolute)
				.optimize(new MaxEval(evaluations), new InitialGuess(guess), GoalType.MINIMIZE,
					new ObjectiveFunction(seen::value), new NelderMeadSimplex(spread))
				.getPoint();
		} catch (final TooManyEvaluationsException e) {
			return seen.point;
		}
	}

	/** Remembers the lowest point. */
	private static final class Lowest {

		private final ToDoubleFunction<double[]> function;
		private final Progress progress;
		private double[] point;
		private double value = Double.POSITIVE_INFINITY;

		Lowest(final ToDoubleFunction<double[]> function, final Progress progress,
			final double[] guess) {
			this.function = function;
			this.progress = progress;
			point = guess.clone();
		}

		double value(final double[] at) {
			progress.checkCancelled();
			final double here = function.applyAsDouble(at);
			if (here < value) {
				value = here;
				point = at.clone();
			}
			return here;
		}
	}
}
