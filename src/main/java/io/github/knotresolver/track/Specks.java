
package io.github.knotresolver.track;

import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Observation;

/**
 * Objects that are too short to be filaments. Those that are longer than a spot is may be a part of
 * a filament that they stay beside.
 *
 * @param chains each of them in all frames, in pixels
 * @param sigma standard deviation of the line in pixels
 */
record Specks(List<List<Chain>> chains, double sigma) {

	private static final String WHY = "Doubtful: a short piece of line that is not counted as a filament stays beside this one and may be a part of it.";

	/**
	 * @param objects in all frames
	 * @param sigma standard deviation of the line in pixels
	 */
	static Specks of(final List<List<Chain>> objects, final double sigma) {
		final double shortest = shortestFilament(sigma);
		return new Specks(objects.stream().filter(c -> c.get(0).length() < shortest).toList(),
			sigma);
	}

	/** Length in pixels of which a filament is at least, by the line's sigma. */
	static double shortestFilament(final double sigma) {
		return SceneTuning.SCENE_SPECK * sigma;
	}

	/** Whether an object is one of them. */
	boolean has(final List<Chain> object) {
		return chains.contains(object);
	}

	/**
	 * A filament that a piece of line stays beside is not believed in any frame: without it, it is
	 * not the filament. O(frames * length * length of the pieces).
	 *
	 * @param filament in all frames
	 * @param observed what was said of it
	 */
	List<Observation> doubted(final List<Chain> filament, final List<Observation> observed) {
		return stayBeside(filament)
			? observed.stream().map(o -> o.atMost(TrackTuning.GUESSED, WHY)).toList()
			: observed;
	}

	/** Whether a piece of line, longer than a spot, stays beside a filament. */
	boolean stayBeside(final List<Chain> filament) {
		final double width = LineAppearance.FULL_WIDTH * sigma;
		return chains.stream().anyMatch(c -> c.get(0).length() > SceneTuning.SPECK_LINE * sigma
			&& staysBeside(c, filament, width));
	}

	private static boolean staysBeside(final List<Chain> piece, final List<Chain> filament,
		final double width) {
		final long beside = IntStream.range(0, piece.size())
			.filter(t -> isBeside(piece.get(t), filament.get(t).contour(), width)).count();
		return beside > SceneTuning.STAYS_BESIDE * piece.size();
	}

	private static boolean isBeside(final Chain piece, final Polyline contour, final double width) {
		final Polyline nodes = piece.polyline();
		return IntStream.range(0, nodes.size())
			.anyMatch(i -> contour.distanceTo(nodes.point(i)) < width);
	}

	/** What a user should know of them. */
	List<String> notes() {
		return chains.isEmpty()
			? List.of()
			: List.of(chains.size() + (chains.size() == 1 ? " object was" : " objects were")
				+ " modelled but not counted as filaments: they are shorter than "
				+ Math.round(SceneTuning.SCENE_SPECK) + " times the line's sigma.");
	}
}
