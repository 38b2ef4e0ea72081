package io.github.knotresolver.evaluate;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

import io.github.knotresolver.evaluate.SceneCurve.Agreement;
import io.github.knotresolver.evaluate.SceneEvaluation.FilamentScore;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;

/** Compares all filaments of a result with all true ones, frame by frame, and counts. */
final class SceneScorer {

	private final SortedMap<Integer, SortedMap<Integer, Polyline>> truth;
	private final SortedMap<Integer, SortedMap<Integer, Polyline>> result;
	private final Map<Integer, Map<Integer, Double>> confidence;
	private final List<Integer> trueNumbers;
	private final List<Integer> resultNumbers;
	/** Frames in which a true and a resulting filament agree, forwards and backwards. */
	private final int[][] forward, backward;
	private final SortedMap<Integer, Frame> frames = new TreeMap<>();

	/** What agrees with what in a frame, and which true filaments cross. */
	private record Frame(Map<Integer, Boolean> crossing,
		Map<Integer, Map<Integer, Agreement>> agreements) {

		Agreement of(final int filament, final int given) {
			return agreements.getOrDefault(filament, Map.of()).getOrDefault(given, Agreement.NONE);
		}
	}

	SceneScorer(final SortedMap<Integer, SortedMap<Integer, Polyline>> truth,
		final SortedMap<Integer, SortedMap<Integer, Polyline>> result,
		final Map<Integer, Map<Integer, Double>> confidence) {
		this.truth = truth;
		this.result = result;
		this.confidence = confidence;
		trueNumbers = List.copyOf(truth.keySet());
		resultNumbers = List.copyOf(result.keySet());
		forward = new int[trueNumbers.size()][resultNumbers.size()];
		backward = new int[trueNumbers.size()][resultNumbers.size()];
	}

	SceneEvaluation score(final Progress progress) {
		final SortedSet<Integer> numbers = new TreeSet<>();
		truth.values().forEach(f -> numbers.addAll(f.keySet()));
		for (final int t : numbers) {
			progress.checkCancelled();
			frames.put(t, compare(t));
			progress.report("Comparing", (double) frames.size() / numbers.size());
		}
		final List<FilamentScore> scores = filaments(progress);
		int all = 0, crossing = 0, resolved = 0, resolvedCrossing = 0, found = 0;
		for (final Frame frame : frames.values())
			for (final FilamentScore score : scores) {
				final Boolean crosses = frame.crossing.get(score.filament());
				if (crosses == null)
					continue;
				final boolean right = isRight(frame, score);
				all++;
				crossing += crosses ? 1 : 0;
				resolved += right ? 1 : 0;
				resolvedCrossing += right && crosses ? 1 : 0;
				found += frame.agreements.containsKey(score.filament()) ? 1 : 0;
			}
		final List<int[]> wrong = wrong();
		return new SceneEvaluation(scores, resultNumbers.size(), all, crossing, resolved,
			resolvedCrossing, found, switches(), shown(), wrong.size(), silent(wrong));
	}

	private Frame compare(final int t) {
		final Map<Integer, SceneCurve> mine = curves(truth, t), theirs = curves(result, t);
		final Map<Integer, Boolean> crossing = new TreeMap<>();
		final Map<Integer, Map<Integer, Agreement>> agreements = new TreeMap<>();
		mine.forEach((g, curve) -> {
			crossing.put(g, curve.crossesItself() || mine.entrySet().stream()
				.anyMatch(o -> !o.getKey().equals(g) && curve.crosses(o.getValue())));
			theirs.forEach((r, other) -> {
				final Agreement agreement = curve.agreement(other);
				if (agreement == Agreement.NONE)
					return;
				agreements.computeIfAbsent(g, k -> new TreeMap<>()).put(r, agreement);
				final int i = trueNumbers.indexOf(g), j = resultNumbers.indexOf(r);
				forward[i][j] += agreement == Agreement.BACKWARD ? 0 : 1;
				backward[i][j] += agreement == Agreement.FORWARD ? 0 : 1;
			});
		});
		return new Frame(crossing, agreements);
	}

	private static Map<Integer, SceneCurve> curves(
		final SortedMap<Integer, SortedMap<Integer, Polyline>> filaments, final int t) {
		final Map<Integer, SceneCurve> curves = new TreeMap<>();
		filaments.forEach((number, contours) -> {
			final Polyline contour = contours.get(t);
			if (contour != null && contour.length() > 0)
				curves.put(number, new SceneCurve(contour));
		});
		return curves;
	}

	private List<FilamentScore> filaments(final Progress progress) {
		final double[][] agreeing = new double[trueNumbers.size()][resultNumbers.size()];
		for (int i = 0; i < agreeing.length; i++)
			for (int j = 0; j < agreeing[i].length; j++)
				agreeing[i][j] = Math.max(forward[i][j], backward[i][j]);
		final int[] given = Assignment.best(agreeing, resultNumbers.size());
		final List<FilamentScore> scores = new ArrayList<>();
		for (int i = 0; i < given.length; i++) {
			final int j = given[i];
			final boolean reversed = j >= 0 && backward[i][j] > forward[i][j];
			final SortedMap<Integer, Polyline> contours = new TreeMap<>();
			if (j >= 0)
				result.get(resultNumbers.get(j))
					.forEach((t, c) -> contours.put(t, reversed ? c.reversed() : c));
			scores.add(new FilamentScore(trueNumbers.get(i),
				j >= 0 ? OptionalInt.of(resultNumbers.get(j)) : OptionalInt.empty(), reversed,
				Evaluation.of(truth.get(trueNumbers.get(i)), contours, progress)));
		}
		return scores;
	}

	private static boolean isRight(final Frame frame, final FilamentScore score) {
		if (!score.isGiven())
			return false;
		final Agreement agreement = frame.of(score.filament(), score.result().getAsInt());
		return agreement == Agreement.BOTH
			|| agreement == (score.reversed() ? Agreement.BACKWARD : Agreement.FORWARD);
	}

	private int switches() {
		int switches = 0;
		for (final int g : trueNumbers) {
			int last = 0;
			for (final Frame frame : frames.values()) {
				final Map<Integer, Agreement> hits = frame.agreements.get(g);
				if (hits == null)
					continue;
				final int now = hits.containsKey(last) ? last : hits.keySet().iterator().next();
				if (last != 0 && now != last)
					switches++;
				last = now;
			}
		}
		return switches;
	}

	private int shown() {
		return (int) result.values().stream().flatMap(f -> f.values().stream())
			.filter(c -> c.length() > 0).count();
	}

	/** @return filament and frame of every contour that agrees with no true one */
	private List<int[]> wrong() {
		final List<int[]> wrong = new ArrayList<>();
		result.forEach((r, contours) -> contours.forEach((t, contour) -> {
			final Frame frame = frames.get(t);
			final boolean agrees = frame != null
				&& frame.agreements.values().stream().anyMatch(a -> a.containsKey(r));
			if (contour.length() > 0 && !agrees)
				wrong.add(new int[]{r, t});
		}));
		return wrong;
	}

	private int silent(final List<int[]> wrong) {
		return confidence.isEmpty()
			? -1
			: (int) wrong.stream().filter(w -> confidence.getOrDefault(w[0], Map.of())
				.getOrDefault(w[1], 0.0) > Observation.SURE).count();
	}
}
