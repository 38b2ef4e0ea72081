
package io.github.knotresolver.track;

import java.util.Collection;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * How much of a movie's light contours leave unexplained, however they were found: by it one
 * filament and several can be compared. The lines are those of a scene.
 */
public final class LightLeft {

	private final SceneLine line;
	private final Workers workers;

	/**
	 * O(pixels of the movie).
	 *
	 * @param frames the movie, at least one frame
	 * @param kinds how strands may add up, at least one
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	public LightLeft(final List<FrameView> frames, final Collection<LineModel.Kind> kinds,
		final Workers workers, final Progress progress) {
		line = SceneLine.learn(frames, kinds, workers, progress);
		this.workers = workers;
	}

	/**
	 * The price of an explanation: light that is left or too much, in strands squared, mean over the
	 * frames, and a price for each filament. O(pixels of the movie).
	 *
	 * @param contours for each frame its filaments' contours in pixels; those that are not known
	 *          are missing
	 * @param filaments how many filaments there are
	 * @return the price; of two explanations the cheaper one is right
	 */
	public double price(final List<List<Polyline>> contours, final int filaments) {
		return workers.map(contours.size(), t -> left(t, contours.get(t))).stream()
			.mapToDouble(Double::doubleValue).average().orElse(0)
			+ SceneTuning.PER_FILAMENT * filaments;
	}

	private double left(final int t, final List<Polyline> contours) {
		return line.left(t, contours.stream().filter(c -> c.length() > 0)
			.map(c -> Chain.inScene(c, c.length())).toList());
	}
}
