package io.github.knotresolver.fit;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.EndLight.Piece;
import io.github.knotresolver.fit.LineEstimator.Example;
import io.github.knotresolver.fit.LineEstimator.LineEstimate;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Workers;

/**
 * The light beyond the ends in many frames together. Where an end tapers, or is darker than
 * what is before it, a curve that is fitted as if it were as bright ends before it; what is left
 * is too dim to be sure of in one frame, but it is there in all of them.
 *
 * @param line the line as it is known
 * @param workers threads
 */
record TaperedEnds(LineEstimate line, Workers workers) {

	/**
	 * Curves that go on where light does.
	 *
	 * @param examples frames and curves, at least one
	 * @return the same with curves that are longer at the ends where it does; the same list if at
	 *         none
	 */
	List<Example> grown(final List<Example> examples) {
		return grown(grown(examples, false), true);
	}

	private List<Example> grown(final List<Example> examples, final boolean atStart) {
		final LineModel model = atStart ? line.model().reversed() : line.model();
		final List<EndLight> lights = examples.stream().map(line::scaled)
			.map(f -> new EndLight(f, model, f.noise())).toList();
		final List<Chain> chains = examples.stream()
			.map(e -> atStart ? e.chain().reversed() : e.chain()).toList();
		final List<Piece> pieces = workers.map(examples.size(),
			i -> lights.get(i).beyondTip(chains.get(i)));
		if (usual(pieces, Piece::brightness) < FitTuning.TAPER_BRIGHT
			|| usual(pieces, Piece::sureness) * Math.sqrt(pieces.size()) < FitTuning.TAPER_SURE)
			return examples;
		return IntStream.range(0, examples.size()).mapToObj(i -> {
			final Chain grown = lights.get(i).grown(chains.get(i), pieces.get(i));
			return new Example(examples.get(i).frame(), atStart ? grown.reversed() : grown);
		}).toList();
	}

	private static double usual(final List<Piece> pieces, final ToDoubleFunction<Piece> value) {
		return RobustStatistics.median(pieces.stream().mapToDouble(value).toArray());
	}
}
