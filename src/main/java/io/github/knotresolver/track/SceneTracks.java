
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings.AnchorChoice;
import io.github.knotresolver.track.SceneSettler.Settled;

/**
 * All filaments of a movie with their contours.
 *
 * @param model what a line looks like
 * @param filaments the filaments: clamped ones first, then the longest
 * @param inPieces whether something that is too short to be a filament, but may be a part of one,
 *          stays beside a filament
 * @param notes what a user should know, a sentence each
 */
public record SceneTracks(LineModel model, List<Filament> filaments, boolean inPieces,
	List<String> notes) {

	/** Clamped filaments first, then the longest. */
	private static final Comparator<Filament> ORDER = Comparator
		.comparing((Filament f) -> !f.clamped())
		.thenComparing(Comparator.comparingDouble(Filament::length).reversed());

	/**
	 * A filament.
	 *
	 * @param clamped whether one end is held: then contours begin there
	 * @param roams whether both ends were seen to go far
	 * @param length in pixels
	 * @param lengthError its standard error in pixels; NaN if not known
	 * @param frames one observation for each frame, in order
	 */
	public record Filament(boolean clamped, boolean roams, double length, double lengthError,
		List<Observation> frames) {

		/** Whether it is held near a place: the median of its first points is. */
		private boolean isHeldAt(final Point place) {
			final List<Point> starts = frames.stream().flatMap(o -> o.contour().stream())
				.map(Polyline::first).toList();
			return clamped && !starts.isEmpty()
				&& RobustStatistics.median(starts).distanceTo(place) < SceneTuning.PLACE_NEAR;
		}

		/** How far it is from a place in a frame, in pixels; infinite if it is not seen there. */
		private double distance(final int t, final Point place) {
			return frames.get(t).contour().map(c -> c.distanceTo(place))
				.orElse(Double.POSITIVE_INFINITY);
		}

		/** @return the mean over all frames; a frame without a contour counts 0 */
		public double meanConfidence() {
			return frames.stream().mapToDouble(o -> o.contour().isPresent() ? o.confidence() : 0)
				.average().orElse(0);
		}
	}

	/**
	 * What is known of all filaments.
	 *
	 * @param line what lines look like, and the frames
	 * @param settled the filaments
	 * @param clear for each filament and frame whether the light around it is explained
	 * @param anchor whether filaments are held at one end
	 */
	static SceneTracks of(final SceneLine line, final List<Settled> settled,
		final boolean[][] clear, final AnchorChoice anchor) {
		final int n = line.frames().size();
		final List<List<Chain>> chains = new ArrayList<>();
		final List<FilamentEnds> ends = new ArrayList<>();
		for (int k = 0; k < settled.size(); k++) {
			final List<Chain> found = settled.get(k).chains();
			final FilamentEnds e = FilamentEnds.of(found, clear[k], anchor);
			ends.add(e);
			chains.add(e.reversed() ? found.stream().map(Chain::reversed).toList() : found);
		}
		final List<List<Observation>> observed = new ArrayList<>();
		final double[] usual = new double[settled.size()];
		for (int k = 0; k < usual.length; k++) {
			observed.add(new ArrayList<>());
			usual[k] = SceneSettler.usualMotion(chains.get(k));
		}
		final double[] elsewhere = usual.length < 2 ? new double[1] : unclear(clear);
		final double noise = line.noise();
		final Hiding hiding = new Hiding(SceneWeights.DEFAULT);
		for (int t = 0; t < n; t++) {
			final List<Chain> here = new ArrayList<>();
			for (final List<Chain> c : chains)
				here.add(c.get(t));
			final FrameView frame = line.frames().get(t);
			final Scene scene = line.scene(t, here);
			final Unexplained left = new Unexplained(scene, noise);
			for (int k = 0; k < usual.length; k++) {
				final double haste = haste(chains.get(k), t) / usual[k];
				final double gap = Math.min(settled.get(k).gap()[t], hiding.gap(scene, k));
				final SceneConfidence confidence = new SceneConfidence(gap,
					left.worstBeside(here.get(k), here),
					SceneConfidence.dark(frame.light(), here.get(k)), haste, elsewhere[k]);
				observed.get(k).add(observation(frame, here.get(k), confidence));
			}
		}
		final List<Filament> found = new ArrayList<>();
		final Specks specks = Specks.of(chains, line.tables().model().sigma());
		boolean inPieces = false;
		for (int k = 0; k < usual.length; k++)
			if (!specks.has(chains.get(k))) {
				inPieces |= specks.stayBeside(chains.get(k));
				found.add(new Filament(ends.get(k).clamped(), ends.get(k).roams(),
					chains.get(k).get(0).length(), settled.get(k).lengthError(),
					specks.doubted(chains.get(k),
						ends.get(k).doubted(SceneConfidence.together(observed.get(k))))));
			}
		found.sort(ORDER);
		final List<Filament> filaments = PartsOfOne.doubted(found);
		final List<String> notes = new ArrayList<>(new DoubtfulEpisodes(filaments).notes());
		notes.addAll(specks.notes());
		return new SceneTracks(line.tables().model(), filaments, inPieces, notes);
	}

	/** For each filament the share of frames in which it is not clear. */
	private static double[] unclear(final boolean[][] clear) {
		final double[] unclear = new double[clear.length];
		for (int k = 0; k < clear.length; k++) {
			for (final boolean c : clear[k])
				unclear[k] += c ? 0 : 1;
			unclear[k] /= clear[k].length;
		}
		return unclear;
	}

	/**
	 * @return whether there is one filament, and nothing speaks for its being free
	 */
	public boolean isOneClamped() {
		return filaments.size() == 1 && (filaments.get(0).clamped() || !filaments.get(0).roams()
			&& filaments.get(0).meanConfidence() < SceneTuning.CREDIBLE);
	}

	/**
	 * The filament that lies under a point in the first frame in which one does, if it is free and
	 * was seen to go far with both ends, or is told to be free.
	 *
	 * @param place in pixels
	 * @return that filament alone; empty if there is none, or a held one ends there
	 */
	Optional<SceneTracks> freeUnder(final Point place) {
		if (filaments.stream().anyMatch(f -> f.isHeldAt(place)))
			return Optional.empty();
		final int n = filaments.isEmpty() ? 0 : filaments.get(0).frames.size();
		for (int t = 0; t < n; t++) {
			final int frame = t;
			final Optional<Filament> nearest = filaments.stream()
				.min(Comparator.comparingDouble(f -> f.distance(frame, place)));
			if (nearest.get().distance(t, place) < SceneTuning.PLACE_NEAR)
				return nearest.filter(f -> !f.clamped && f.roams).map(this::only);
		}
		return Optional.empty();
	}

	private SceneTracks only(final Filament filament) {
		final List<String> one = new ArrayList<>(List.of(
			"The filament at the point that was told is held nowhere: both of its ends go far. It was followed as a free one"
				+ (filaments.size() > 1 ? ", one of " + filaments.size() + " filaments." : ".")));
		one.addAll(new DoubtfulEpisodes(List.of(filament)).notes());
		return new SceneTracks(model, List.of(filament), inPieces, one);
	}

	private static double haste(final List<Chain> chains, final int t) {
		double most = 0;
		for (int u = Math.max(1, t); u <= Math.min(chains.size() - 1, t + 1); u++)
			most = Math.max(most, chains.get(u - 1).distance(chains.get(u)));
		return most;
	}

	private static Observation observation(final FrameView frame, final Chain chain,
		final SceneConfidence confidence) {
		final double visible = SceneConfidence.visible(frame.light(), chain);
		if (visible < SceneTuning.IN_VIEW)
			return Observation
				.without(frame.frame(), FrameStatus.ABSENT, "The filament is not in view.")
				.withVisible(visible);
		if (confidence.dark() > SceneTuning.SCENE_LOST)
			return Observation.without(frame.frame(), FrameStatus.LOST,
				"No light was found where the filament must be.");
		final double value = confidence.value();
		if (value < SceneTuning.SCENE_HOPELESS)
			return Observation.without(frame.frame(), FrameStatus.UNRESOLVED,
				"No course was found that can be the filament's. " + confidence.reason());
		if (confidence.dark() > SceneTuning.SCENE_UNRESOLVED)
			return Observation.without(frame.frame(), FrameStatus.UNRESOLVED,
				"The best contour runs in the dark for " + Math.round(100 * confidence.dark())
					+ " % of its length.");
		final Polyline contour = chain.contour();
		return new Observation(frame.frame(), FrameStatus.RESOLVED, confidence.reason(),
			Optional.of(contour), frame.graph().junctions(), 1, confidence.unexplained(), value)
			.withVisible(visible);
	}
}
