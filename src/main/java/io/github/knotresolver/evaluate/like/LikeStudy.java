package io.github.knotresolver.evaluate.like;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.evaluate.like.LikeResult.LikeMotion;
import io.github.knotresolver.evaluate.like.LikeResult.LikeMovie;
import io.github.knotresolver.evaluate.like.LikeResult.LikeTraits;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.FilamentChoice;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.session.Engine;
import io.github.knotresolver.simulate.Canvas;
import io.github.knotresolver.simulate.FilamentSimulator;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;
import io.github.knotresolver.simulate.SimulatedMovie;

/**
 * Simulates movies that resemble a user's, resolves them with the user's
 * parameters and scores them.
 * <p>
 * The same seed gives the same result, whatever the number of threads. Cost:
 * twelve simulations to find the motion; then a simulation and its contours for
 * every movie.
 */
public final class LikeStudy {

	/** Movies if nothing else is said. */
	public static final int MOVIES = 10;

	private static final int MOST_MOVIES = 1000, MARGIN = 20;

	/** The filament's light ends this many widths from its middle. */
	private static final double REACH = 1.5;

	private final LikeSource source;
	private final Engine engine;
	private final Appearance look;
	private final Motion motion;
	private final Backdrop backdrop;

	/**
	 * Measures the user's movie.
	 *
	 * @param source the user's result
	 * @param engine what resolves the simulated movies
	 * @param progress may cancel
	 * @throws UserException if the movie shows no line along the
	 *           contours, in one sentence
	 */
	public LikeStudy(final LikeSource source, final Engine engine, final Progress progress) {
		this.source = source;
		this.engine = engine;
		progress.report("Measuring the movie", 0);
		look = AppearanceMeter.of(source.movie(), source.contours(), progress);
		motion = Motion.of(source.contours(), look.width());
		backdrop = new Backdrop(source.movie(), source.contours(), REACH * look.width() + 1,
			look.background());
	}

	/**
	 * @param movies how many, 1 to 1000
	 * @throws UserException if it is another number, in one sentence
	 */
	public static void check(final int movies) {
		if (movies < 1 || movies > MOST_MOVIES)
			throw new UserException("movies must be a whole number from 1 to " + MOST_MOVIES
				+ ", but is " + movies + ".");
	}

	/**
	 * Does everything.
	 *
	 * @param movies how many, 1 to 1000
	 * @param seed start of the random numbers
	 * @param progress told how far it is; may cancel
	 * @return the movies' scores
	 */
	public LikeResult run(final int movies, final long seed, final Progress progress) {
		check(movies);
		return run(motion(seed, progress), movies, seed, progress);
	}

	private LikeMotion motion(final long seed, final Progress progress) {
		try (Workers workers = new Workers(source.parameters().threads())) {
			return new MotionSearch(source, motion, look.width()).search(seed, workers, progress);
		}
	}

	/** The movies of a motion that is known already. */
	LikeResult run(final LikeMotion like, final int movies, final long seed,
		final Progress progress) {
		try (Workers workers = new Workers(source.parameters().threads())) {
			final List<LikeMovie> done = workers.map("Simulating and resolving", progress, movies,
				i -> one(like, seed + 1 + i, progress.silent()));
			return new LikeResult(source, like, traits(), done, seed);
		}
	}

	private LikeTraits traits() {
		return LikeTraits.of(source.movie(), source.contours(), look, motion);
	}

	/**
	 * Simulates one movie.
	 *
	 * @param like what to simulate
	 * @param seed start of the random numbers
	 * @param progress may cancel
	 * @return the movie with its truth
	 */
	public SimulatedMovie movie(final LikeMotion like, final long seed, final Progress progress) {
		final Trajectory straight = new FilamentSimulator(
			like.simulation(source.movie().size(), seed)).run(progress);
		final Polyline first = source.contours().stream().flatMap(Optional::stream).findFirst()
			.orElseThrow();
		final Calibration c = source.movie().calibration();
		final Trajectory turned = new Trajectory(straight.curves().stream()
			.map(curve -> turned(curve, MotionSearch.direction(first))).toList(),
			c.frameInterval());
		final Canvas canvas = Canvas.around(turned, source.pixelSize(), MARGIN);
		final SimulatedMovie drawn = SimulatedMovie.render("like-" + seed, turned, canvas,
			new LikeRenderer(backdrop, look, first.first(), seed), look.range().depth(), progress);
		return new SimulatedMovie(new Movie(drawn.movie().name(), drawn.movie().frames(), c),
			drawn.truth());
	}

	private static Polyline turned(final Polyline curve, final double angle) {
		final double cos = StrictMath.cos(angle), sin = StrictMath.sin(angle);
		final double[] x = new double[curve.size()], y = new double[curve.size()];
		for (int i = 0; i < x.length; i++) {
			x[i] = cos * curve.x(i) - sin * curve.y(i);
			y[i] = sin * curve.x(i) + cos * curve.y(i);
		}
		return Polyline.of(x, y);
	}

	private LikeMovie one(final LikeMotion like, final long seed, final Progress progress) {
		final SimulatedMovie simulated = movie(like, seed, progress);
		final SortedMap<Integer, Polyline> truth = new TreeMap<>(), found = new TreeMap<>();
		for (int t = 0; t < simulated.truth().size(); t++)
			truth.put(t + 1, simulated.truth().get(t));
		final List<Double> confidence = new ArrayList<>();
		Optional<String> refusal = Optional.empty();
		try {
			for (final Observation f : engine
				.resolve(simulated.movie(), parameters(simulated), progress).only().frames()) {
				f.contour().ifPresent(contour -> found.put(f.frame(), contour));
				confidence.add(f.confidence());
			}
		} catch (final UserException e) {
			// A movie in which no filament is found is one without contours.
			refusal = Optional.of(e.getMessage());
			confidence.addAll(Collections.nCopies(truth.size(), Double.NaN));
		}
		return new LikeMovie(
			seed, Evaluation.of(truth, found, progress), simulated.truth().stream()
				.map(c -> Motion.Shape.of(c, look.width()).knotted()).toList(),
			confidence, traits(simulated, progress), refusal);
	}

	private LikeTraits traits(final SimulatedMovie simulated, final Progress progress) {
		final List<Optional<Polyline>> truth = simulated.truth().stream().map(Optional::of)
			.toList();
		final Appearance own = look.range()
			.undone(AppearanceMeter.of(simulated.movie(), truth, progress));
		return LikeTraits.of(simulated.movie(), truth, own, Motion.of(truth, look.width()));
	}

	/** The user's, in one thread; what was told of places and frames cannot be told again. */
	private Settings parameters(final SimulatedMovie simulated) {
		final Settings p = source.parameters();
		final Polyline first = simulated.truth().get(0);
		return p.edit().fixedEnd(p.fixedEnd().map(told -> first.first())).region(Optional.empty())
			.length(
				p.length().isPresent() ? OptionalDouble.of(first.length()) : OptionalDouble.empty())
			.frames(Set.of()).ignoreFrames(Set.of()).corrections(Map.of())
			.filaments(FilamentChoice.ONE).threads(1).build();
	}
}
