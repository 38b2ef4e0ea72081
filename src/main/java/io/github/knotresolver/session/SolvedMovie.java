package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.GraphTuning;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.AnchorChoice;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.FixedEndFinder;
import io.github.knotresolver.track.FrameView;
import io.github.knotresolver.track.SceneResolver;
import io.github.knotresolver.track.SceneTracks;
import io.github.knotresolver.track.SingleFilament;
import io.github.knotresolver.track.StillLines;
import io.github.knotresolver.track.Track;

/** A movie as far as it is known without a word of the user: frames as graphs, and who answers. */
final class SolvedMovie {

	private final Movie movie;
	private final PreparedMovie prepared;
	private final Optional<SceneTracks> scene;
	private final Optional<FrameResolver> single;
	/** Lines that lie still; they come after all others. */
	private final List<SceneTracks.Filament> still;

	private SolvedMovie(final Movie movie, final PreparedMovie prepared,
		final List<SceneTracks.Filament> still, final Optional<SceneTracks> scene,
		final Optional<FrameResolver> single) {
		this.movie = movie;
		this.still = still;
		this.prepared = prepared;
		this.scene = scene;
		this.single = single;
	}

	/**
	 * Walks the movie from pixels to graphs, and finds out whether one filament is in it or
	 * several.
	 *
	 * @param wanted 1-based numbers of the frames to resolve, in order
	 */
	static SolvedMovie look(final Movie movie, final Settings settings, final List<Integer> wanted,
		final Workers workers, final Progress progress) {
		final PreparedMovie whole = PreparedMovie.of(movie, settings, wanted, workers, progress);
		if (whole.frames().isEmpty())
			throw nothingFound(movie, settings);
		final Progress placed = new PlacedProgress(progress, whole.pixels()::out);
		final StillLines.Found still = still(whole, settings, workers, placed);
		final PreparedMovie prepared = still.lines().isEmpty()
			? whole
			: whole.with(still.rest(), note(still.lines().size()));
		final boolean alone = settings.anchor() != AnchorChoice.FREE
			&& SingleFilament.isClampedAlone(prepared.frames());
		final SceneResolver scenes = new SceneResolver(prepared.frames(), prepared.kinds(), workers,
			placed);
		final Optional<SceneTracks> scene = alone || !settings.deliversAll()
			? Optional.empty()
			: scene(scenes, settings);
		if (scene.isPresent() && !mayBeOne(scene.get(), settings, prepared))
			return new SolvedMovie(movie, prepared, still.lines(), scene, Optional.empty());
		final Optional<SceneTracks> told = alone ? Optional.empty() : told(scenes, whole, settings);
		if (told.isPresent())
			return new SolvedMovie(movie, prepared, still.lines(), told, Optional.empty());
		final FrameResolver single = single(movie, prepared, settings, scenes, scene.isEmpty(),
			placed);
		final boolean undecided = scene.isPresent() || alone && settings.deliversAll();
		final Optional<Track> one = undecided
			? single.resolve(List.of(), workers, placed)
			: Optional.empty();
		final boolean doubtful = undecided
			&& one.map(t -> Verdict.isDoubtful(t.frames())).orElse(true);
		final Optional<SceneTracks> many = doubtful && scene.isEmpty()
			? scene(scenes, settings)
			: scene;
		// What was put together from several explains their light, but not well.
		final boolean isOne = many.isEmpty()
			|| one.isPresent() && (!doubtful || scene.isEmpty() || isDoubtful(scene.get()))
				&& scenes.isOne(one.get().frames(), many.get());
		return isOne
			? new SolvedMovie(movie, prepared, still.lines(), Optional.empty(), Optional.of(single))
			: new SolvedMovie(movie, prepared, still.lines(), many, Optional.empty());
	}

	/** Lines that lie still, and the movie without them. */
	private static StillLines.Found still(final PreparedMovie prepared, final Settings settings,
		final Workers workers, final Progress progress) {
		return settings.fitsTrails()
			? StillLines.in(prepared.frames(), prepared.kinds(),
				prepared.pixels().of(settings).fixedEnd().stream().toList(), workers, progress)
			: new StillLines.Found(prepared.frames(), List.of());
	}

	private static String note(final int lines) {
		return (lines == 1 ? "A line lies still" : lines + " lines lie still")
			+ " while something moves over " + (lines == 1 ? "it; its" : "them; their")
			+ " light was taken off before all else was followed.";
	}

	/** All filaments of the movie; empty if it holds one that is clamped. */
	private static Optional<SceneTracks> scene(final SceneResolver scenes,
		final Settings settings) {
		return scenes.resolve(settings.anchor()).filter(s -> !s.filaments().isEmpty()
			&& (settings.anchor() == AnchorChoice.FREE || !s.isOneClamped()));
	}

	/** The filament at the point that was told, if that is a free one. */
	private static Optional<SceneTracks> told(final SceneResolver scenes,
		final PreparedMovie prepared, final Settings settings) {
		return settings.deliversAll() || !settings.fitsTrails()
			|| settings.anchor() == AnchorChoice.CLAMPED
				? Optional.empty()
				: prepared.pixels().of(settings).fixedEnd()
					.flatMap(end -> scenes.freeUnder(end, settings.anchor()));
	}

	/** Whether several filaments may be one that lies on itself, or one that was taken to pieces. */
	private static boolean mayBeOne(final SceneTracks scene, final Settings settings,
		final PreparedMovie prepared) {
		return settings.anchor() != AnchorChoice.FREE
			&& (scene.filaments().size() > 1 || scene.inPieces()) && settings.fitsTrails()
			&& (isDoubtful(scene)
				? SingleFilament.isMostlyOneObject(prepared.frames())
				: SingleFilament.isOneObject(prepared.frames()));
	}

	private static boolean isDoubtful(final SceneTracks scene) {
		return Verdict
			.isDoubtful(scene.filaments().stream().flatMap(f -> f.frames().stream()).toList());
	}

	private static FrameResolver single(final Movie movie, final PreparedMovie prepared,
		final Settings settings, final SceneResolver scenes, final boolean alone,
		final Progress progress) {
		final Settings working = prepared.pixels().of(settings);
		progress.report("Looking for the fixed end", 0);
		settings.fixedEnd()
			.ifPresent(end -> requireNearObject(end, working.fixedEnd().orElseThrow(), prepared));
		final List<FrameView> frames = alone(prepared, working, scenes);
		final Point fixedEnd = working.fixedEnd()
			.orElseGet(() -> new FixedEndFinder(frames, progress).find()
				.orElseThrow(() -> nothingFound(movie, settings)));
		return new FrameResolver(working, prepared.kinds(), frames, fixedEnd,
			prepared.pixels().binning(), alone);
	}

	/** The frames without the light of filaments that are not meant. */
	private static List<FrameView> alone(final PreparedMovie prepared, final Settings working,
		final SceneResolver scenes) {
		final List<FrameView> frames = prepared.frames();
		return working.fixedEnd().isEmpty() || !working.fitsTrails()
			|| SingleFilament.isClampedAlone(frames)
				? frames
				: scenes.alone(working.fixedEnd().get());
	}

	/**
	 * Answers.
	 *
	 * @param told the settings with all that the user said
	 * @return the result, in the movie's pixels
	 */
	Tracks solve(final Settings told, final Workers workers, final Progress progress) {
		final List<String> notes = new ArrayList<>(prepared.notes());
		final List<FilamentTrack> filaments = new ArrayList<>(scene.isPresent()
			? of(scene.get(), notes)
			: List.of(one(told, notes, workers, progress)));
		final int moving = filaments.size();
		filaments.addAll(SceneDelivery.tracks(delivered(told), moving + 1, this::everyFrame));
		told.constraints().forEach(c -> requireFilament(c, filaments.size()));
		final List<FilamentTrack> exchanged = Exchanges
			.in(filaments.stream().map(prepared.pixels()::out).toList(), told.constraints());
		notes.addAll(Verdict.on(exchanged.subList(0, moving)));
		return new Tracks(movie, told,
			exchanged.stream()
				.map(
					f -> new GivenContours(told.constraints(), scene.isPresent() || f.id() > moving)
						.over(f))
				.toList(),
			notes);
	}

	/** The lines that lie still, if all filaments are asked for. */
	private List<SceneTracks.Filament> delivered(final Settings told) {
		return told.deliversAll() ? still : List.of();
	}

	private List<FilamentTrack> of(final SceneTracks found, final List<String> notes) {
		notes.add("Line model: " + found.model() + ".");
		notes.addAll(found.notes());
		return SceneDelivery.tracks(found.filaments(), 1, this::everyFrame);
	}

	/** The one filament that is clamped. */
	private FilamentTrack one(final Settings told, final List<String> notes, final Workers workers,
		final Progress progress) {
		told.constraints().forEach(c -> requireFilament(c, 1 + delivered(told).size()));
		final Track found = single.orElseThrow()
			.resolve(
				prepared.pixels()
					.in(told.constraints().stream()
						.filter(c -> c.kind().isOfContour() && c.filament() == 1).toList()),
				workers, new PlacedProgress(progress, prepared.pixels()::out))
			.orElseThrow(() -> nothingFound(movie, told));
		if (found.frames().stream().allMatch(f -> f.contour().isEmpty()))
			throw nothingFound(movie, told);
		notes.addAll(found.notes());
		return new FilamentTrack(1, Anchor.CLAMPED, Optional.of(found.fixedEnd()), found.length(),
			found.lengthError(), everyFrame(found.frames()));
	}

	private List<Observation> everyFrame(final List<Observation> found) {
		final Map<Integer, Observation> byFrame = new HashMap<>();
		Verdict.doubted(prepared.withLost(found)).forEach(f -> byFrame.put(f.frame(), f));
		final List<Observation> all = new ArrayList<>();
		for (int frame = 1; frame <= movie.size(); frame++)
			all.add(byFrame.getOrDefault(frame,
				Observation.without(frame, FrameStatus.IGNORED, "Left out, as asked.")));
		return all;
	}

	private static void requireFilament(final Constraint constraint, final int filaments) {
		if (constraint.filament() > filaments)
			throw new UserException("corrections name filament " + constraint.filament()
				+ ", but the movie has " + filaments + (filaments == 1 ? "." : " filaments."));
	}

	private static void requireNearObject(final Point end, final Point working,
		final PreparedMovie prepared) {
		final double nearest = prepared.pixels().binning() * prepared.frames().stream()
			.mapToDouble(f -> f.distance(working)).min().orElse(Double.POSITIVE_INFINITY);
		if (nearest > GraphTuning.NEAR_CLAMP)
			throw new UserException("fixed_end " + end + " is "
				+ (Double.isInfinite(nearest) ? "not near" : Math.round(nearest) + " px from")
				+ " any object in any frame; give a point on the "
				+ "filament's clamped end, in pixels, or none to have it found.");
	}

	private static UserException nothingFound(final Movie movie, final Settings settings) {
		return new UserException(
			"No filament was found in '" + movie.name() + "': no line can be followed in any frame"
				+ settings.fixedEnd()
					.map(end -> " from fixed_end " + end
						+ "; check this point and the channel, or set a threshold.")
					.orElse("; check the channel, tell fixed_end, or set a threshold."));
	}
}
