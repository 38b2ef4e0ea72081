package io.github.knotresolver.reproduction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;

import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;
import io.github.knotresolver.simulate.SimulatedMovie;

/**
 * The published evaluation, run again.
 *
 * @param series the filaments
 * @param results a row for every method, condition, filament and frame seen
 */
public record Reproduction(List<Series> series, List<FrameResult> results) {

	public Reproduction {
		series = List.copyOf(series);
		results = List.copyOf(results);
	}

	/**
	 * Simulates, renders, resolves and judges; says on standard error how far it is.
	 *
	 * @param series the filaments
	 * @return the evaluation
	 */
	static Reproduction run(final List<Series> series) {
		final List<FrameResult> results = new ArrayList<>();
		// The longest take most time; begun first, no thread waits for them at the end.
		final List<Series> slowestFirst = series.stream()
			.sorted(Comparator.comparing((final Series s) -> -s.length() * s.density())).toList();
		final List<Trajectory> trajectories;
		try (Workers workers = new Workers(Runtime.getRuntime().availableProcessors())) {
			trajectories = workers.map(series.size(), i -> {
				System.err.println("Simulating " + slowestFirst.get(i));
				return slowestFirst.get(i).trajectory();
			});
		}
		for (final Series s : series) {
			System.err.println("Resolving " + s);
			final Trajectory trajectory = trajectories.get(slowestFirst.indexOf(s));
			for (final double snr : Condition.NOISE)
				results.addAll(judge(s, snr, s.movie(trajectory, snr)));
		}
		return new Reproduction(series, results);
	}

	private static List<FrameResult> judge(final Series series, final double snr,
		final SimulatedMovie movie) {
		final List<FrameResult> results = new ArrayList<>();
		for (final Condition condition : Condition.at(snr))
			for (final Method method : Method.values())
				results.addAll(new Trial(series, condition, method, movie).run());
		return results;
	}

	/** @return the rows of a method under a condition, by series and frame */
	public List<FrameResult> of(final Method method, final Condition condition) {
		return results.stream().filter(r -> r.method() == method && r.condition().equals(condition))
			.toList();
	}

	/** @return position errors of all points of a method under a condition, in pixels */
	public double[] errors(final Method method, final Condition condition) {
		return of(method, condition).stream().map(FrameResult::errors)
			.flatMapToDouble(Arrays::stream).toArray();
	}

	/** @return how many percent of some rows are resolved */
	static double percentResolved(final List<FrameResult> rows,
		final Predicate<FrameResult> which) {
		return rows.stream().filter(which).mapToDouble(r -> r.isResolved() ? 100 : 0).average()
			.orElse(Double.NaN);
	}
}
