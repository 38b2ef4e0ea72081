package io.github.knotresolver.pipeline;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.pipeline.FrameResolver.Found;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.FixedEndFinder;
import io.github.knotresolver.track.FrameView;
import io.github.knotresolver.track.SceneResolver;
import io.github.knotresolver.track.SceneTracks;
import io.github.knotresolver.track.SingleFilament;

/**
 * The facade: a movie becomes one contour per frame. It walks the rooms in order:
 * image, mask, skeleton, graph, candidate, contour, fit, track.
 */
public final class FilamentResolver {

	/** A told fixed end farther than this (pixels) from any object is a mistake. */
	private static final double FAR = 12;

	private final Settings parameters;

	/**
	 * @param parameters everything that decides the result
	 */
	public FilamentResolver(final Settings parameters) {
		this.parameters = parameters;
	}

	/**
	 * Resolves a movie. The movie is only read.
	 *
	 * @param movie the movie
	 * @param progress told how far the work is, and asked whether to stop
	 * @return one row for every frame of the movie
	 * @throws UserException if the movie or the parameters do not fit
	 *           together, or no filament was found; the message says what to do
	 * @throws io.github.knotresolver.progress.CancelledException if the user asked to
	 *           stop
	 */
	public Tracks resolve(final Movie movie, final Progress progress) {
		if (parameters.region().isPresent())
			return within(parameters.region().get(), movie, progress);
		final List<Integer> wanted = new FrameChoice(movie, parameters).frames();
		try (Workers workers = new Workers(parameters.threads())) {
			return resolve(movie, wanted, workers, progress);
		}
	}

	/** Searches a part of the movie; the result is in the whole movie's pixels. */
	private Tracks within(final Region region, final Movie movie, final Progress progress) {
		final Tracks found = new FilamentResolver(region.of(parameters)).resolve(region.of(movie),
			progress);
		final List<String> notes = new ArrayList<>(found.notes());
		notes.add("Only the region x=" + region.x() + " y=" + region.y() + " width="
			+ region.width() + " height=" + region.height() + " was searched.");
		return new Tracks(movie, parameters, found.filaments().stream().map(region::back).toList(),
			notes);
	}

	private Tracks resolve(final Movie movie, final List<Integer> wanted, final Workers workers,
		final Progress progress) {
		final PreparedMovie prepared = PreparedMovie.of(movie, parameters, wanted, workers,
			progress);
		if (prepared.frames().isEmpty())
			throw nothingFound(movie);
		final Optional<SceneTracks> scene = scene(prepared, workers, progress);
		return scene.isPresent()
			? result(movie, prepared, SceneDelivery.tracks(scene.get(),
				o -> everyFrame(movie, prepared.withLost(o))), sceneNotes(scene.get()))
			: single(movie, prepared, workers, progress);
	}

	/** The one filament that is clamped. */
	private Tracks single(final Movie movie, final PreparedMovie prepared, final Workers workers,
		final Progress progress) {
		final Settings working = prepared.pixels().of(parameters);
		final List<FrameView> frames = prepared.frames();
		progress.report("Looking for the fixed end", 0);
		parameters.fixedEnd()
			.ifPresent(end -> requireNearObject(end, working.fixedEnd().get(), prepared));
		final Point fixedEnd = working.fixedEnd()
			.orElseGet(() -> new FixedEndFinder(frames, progress).find()
				.orElseThrow(() -> nothingFound(movie)));
		final Found found = new FrameResolver(working, prepared.kinds(), workers, progress)
			.resolve(frames, fixedEnd).orElseThrow(() -> nothingFound(movie));
		if (found.frames().stream().allMatch(f -> f.contour().isEmpty()))
			throw nothingFound(movie);
		return result(movie, prepared,
			List.of(new FilamentTrack(1, Anchor.CLAMPED, Optional.of(found.fixedEnd()),
				found.length(), found.lengthError(),
				everyFrame(movie, prepared.withLost(found.frames())))),
			found.notes());
	}

	/** What was found, in the movie's pixels. */
	private Tracks result(final Movie movie, final PreparedMovie prepared,
		final List<FilamentTrack> found, final List<String> more) {
		final List<String> notes = new ArrayList<>(prepared.notes());
		notes.addAll(more);
		return new Tracks(movie, parameters,
			found.stream().map(prepared.pixels()::out).toList(), notes);
	}

	/** All filaments of the movie; empty if it holds one that is clamped, or one is asked for. */
	private Optional<SceneTracks> scene(final PreparedMovie prepared, final Workers workers,
		final Progress progress) {
		if (!parameters.deliversAll() || SingleFilament.isClampedAlone(prepared.frames()))
			return Optional.empty();
		return new SceneResolver(prepared.kinds(), workers, progress)
			.resolve(prepared.frames(), parameters.anchor())
			.filter(s -> s.filaments().size() > 1 || !s.filaments().get(0).clamped());
	}

	private static List<String> sceneNotes(final SceneTracks scene) {
		final List<String> notes = new ArrayList<>();
		notes.add("Line model: " + scene.model() + ".");
		notes.addAll(scene.notes());
		return notes;
	}

	private static List<Observation> everyFrame(final Movie movie,
		final Collection<Observation> found) {
		final Map<Integer, Observation> byFrame = new HashMap<>();
		found.forEach(f -> byFrame.put(f.frame(), f));
		final List<Observation> all = new ArrayList<>();
		for (int frame = 1; frame <= movie.size(); frame++)
			all.add(byFrame.getOrDefault(frame,
				Observation.without(frame, FrameStatus.IGNORED, "Left out, as asked.")));
		return all;
	}

	private static void requireNearObject(final Point end, final Point working,
		final PreparedMovie prepared) {
		final double nearest = prepared.pixels().binning() * prepared.frames().stream()
			.mapToDouble(f -> f.distance(working)).min().orElse(Double.POSITIVE_INFINITY);
		if (nearest > FAR)
			throw new UserException("fixed_end " + end + " is "
				+ (Double.isInfinite(nearest) ? "not near" : Math.round(nearest) + " px from")
				+ " any object in any frame; give a point on the "
				+ "filament's clamped end, in pixels, or none to have it found.");
	}

	private static UserException nothingFound(final Movie movie) {
		return new UserException("No filament was found in '" + movie.name()
			+ "': no line can be followed in any frame; check the channel, "
			+ "tell the fixed end, or set a threshold.");
	}
}
