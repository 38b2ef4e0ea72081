package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.FilamentChoice;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * A movie that can be asked again and again. It keeps what was worked out (evidence and
 * graphs, what the filament looks like, the fits of every frame), so that one more word of
 * the user is answered in a moment: only what depends on it is worked out anew. The answer is
 * the same as that of a new session with the same constraints, in whatever order they came.
 * <p>
 * The first answer walks the rooms in order: image, mask, skeleton, graph, candidate,
 * contour, fit, track. One thread at a time.
 */
public final class Session {

	private final Movie movie;
	private final Settings settings;
	/** The session of the part of the movie that is searched. */
	private final Optional<Session> part;
	/** What the movie tells by itself, once somebody has asked. */
	private Optional<SolvedMovie> known = Optional.empty();

	/**
	 * Nothing is worked out yet.
	 *
	 * @param movie the movie; only read
	 * @param settings everything that decides the result
	 * @throws UserException if the region reaches outside of the movie, in one sentence
	 */
	public Session(final Movie movie, final Settings settings) {
		this.movie = movie;
		this.settings = settings;
		final Settings silent = settings.edit().constraints(List.of())
			.filaments(settings.deliversAll() ? FilamentChoice.ALL : FilamentChoice.ONE).build();
		part = settings.region().map(r -> new Session(r.of(movie), r.of(silent)));
	}

	/**
	 * Resolves the movie.
	 *
	 * @param constraints all that the user says about frames, besides what the settings say;
	 *          in any order
	 * @param progress told how far the work is, and asked whether to stop; after a stop the
	 *          session can be asked again
	 * @return one row for every frame of the movie and every filament; its settings hold all
	 *         constraints
	 * @throws UserException if the movie, the settings and the constraints do not fit
	 *           together, or no filament was found; the message says what to do
	 * @throws io.github.knotresolver.progress.CancelledException if the user asked to
	 *           stop
	 */
	public Tracks solve(final List<Constraint> constraints, final Progress progress) {
		final List<Constraint> all = new ArrayList<>(settings.constraints());
		all.addAll(constraints);
		final Settings told = settings.edit().constraints(all).build();
		final List<Integer> wanted = new FrameChoice(movie, told).frames();
		if (part.isPresent())
			return within(told, progress);
		try (Workers workers = new Workers(settings.threads())) {
			return Cancellation.during(progress, () -> {
				if (known.isEmpty())
					known = Optional
						.of(SolvedMovie.look(movie, settings, wanted, workers, progress));
				return known.get().solve(told, workers, progress);
			});
		}
	}

	/** Searches a part of the movie; the result is in the whole movie's pixels. */
	private Tracks within(final Settings told, final Progress progress) {
		final Region region = told.region().orElseThrow();
		final Tracks found = part.orElseThrow().solve(region.of(told).constraints(),
			new PlacedProgress(progress, region::back));
		final List<String> notes = new ArrayList<>(found.notes());
		notes.add("Only the region x=" + region.x() + " y=" + region.y() + " width="
			+ region.width() + " height=" + region.height() + " was searched.");
		return new Tracks(movie, told, found.filaments().stream().map(region::back).toList(),
			notes);
	}
}
