package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * All that was found in a movie before the user said anything: it is made once, and every
 * answer is chosen from it.
 *
 * @param frames the frames, in order of time
 * @param light their pixels, a strand's brightness 1
 * @param course line, length and fixed end
 * @param sets the candidates of every frame
 * @param fits the fits of every frame
 * @param settings weights of the fits
 */
record FitPools(List<FrameView> frames, List<NormalizedFrame> light, FilamentCourse course,
	List<CandidateSet> sets, List<List<Fit>> fits, FitSettings settings) {

	/** A place has two coordinates, each of which fits the noise of a pixel. */
	private static final int FREEDOM = 2;

	/** @return price of all frames' cheapest fits; a frame that nothing explains costs nothing */
	double price() {
		return fits.stream()
			.mapToDouble(f -> f.stream().mapToDouble(Fit::energy).reduce(0, Math::min)).sum();
	}

	/**
	 * Of a fixed end that moves, as here, and one that stays, the one that explains more light: a
	 * place of its own in each frame explains some of the noise.
	 *
	 * @param still what is found if it stays
	 * @return one of both
	 */
	FitPools orStill(final FitPools still) {
		return still.price() < price() + chance() * fits.size() ? still : this;
	}

	/** How much of a frame's price a place of its own explains of the noise. */
	private double chance() {
		return FREEDOM * course.noise() * course.noise();
	}

	/** @return the fitter of a frame */
	FilamentFitter fitter(final int t) {
		return fitter(t, settings, links());
	}

	private FilamentFitter fitter(final int t, final FitSettings weights, final int links) {
		return fitter(t, Optional.of(course.anchor().at(t)),
			weights.withClampWeight(course.anchor().weight(t)), links);
	}

	private FilamentFitter fitter(final int t, final Optional<Point> clamp,
		final FitSettings weights, final int links) {
		return new FilamentFitter(light.get(t), course.estimate().model(), links, clamp, weights);
	}

	private double width() {
		return LineAppearance.FULL_WIDTH * course.estimate().model().sigma();
	}

	private int links() {
		return FilamentEstimator.links(course.estimate().length());
	}

	/**
	 * What all frames say together of the length, each by where its light begins and ends: where few
	 * show the filament open, or noise or something bright beside it hides an end in these, all know it
	 * better than the clearest. Contours that are held would all be too short or too long by as much as
	 * the clamp is off. A frame in which the tip lies on the filament, or is outside, says nothing; nor
	 * does any if an end is dim, as where it is depends on how bright it is.
	 * O(frames * length).
	 *
	 * @param chosen the contours that were chosen, by index of the frame
	 * @param workers threads
	 * @return the course with that length, and with the clamp where light begins if that is usually
	 *         before one that stays; empty if it is not surely another length, or one that changes
	 */
	Optional<FilamentCourse> lengthOfAll(final List<Observation> chosen, final Workers workers) {
		final FilamentEstimate known = course.estimate();
		if (course.length().kind() != LengthCourse.Kind.CONSTANT || known.model().hasDimEnd())
			return Optional.empty();
		final List<Light> seen = workers.map(chosen.size(),
			t -> GuessedLength.isTipFree(chosen.get(t), known.model())
				? Optional.of(light(t, chosen.get(t).contour().orElseThrow()))
				: Optional.<Light>empty())
			.stream().flatMap(Optional::stream).toList();
		final double late = RobustStatistics
			.median(seen.stream().mapToDouble(Light::late).toArray(), 0);
		// What is dark next to the clamp is filament, and so is what is seen before it.
		return Lengths.common(seen.stream().mapToDouble(l -> l.chain.length()).toArray())
			.map(c -> c.longer(Math.max(0, late)))
			.filter(c -> c.isOtherThan(known.length(), known.lengthError()))
			.map(c -> (late < 0 ? course.withAnchor(beginning(seen)) : course)
				.withEstimate(known.withLength(c.length(), c.error()))
				.withLength(LengthCourse.constant(c.length(), chosen.size())));
	}

	/** A contour that ends, and unless it is held begins, with its light, and how far from the clamp. */
	private record Light(Chain chain, double late) {
	}

	private Light light(final int t, final Polyline contour) {
		final FitSettings anyLength = settings.withFreeLength(true);
		// In noise a start that is not held is farther off than a clamp that all frames say.
		final FilamentFitter fitter = settings.isNoisy()
			? fitter(t, anyLength, links())
			: fitter(t, Optional.empty(), anyLength, links());
		final Chain free = fitter
			.fit(Chain.along(contour, links(), contour.length()), Optional.empty()).chain();
		final Point clamp = course.anchor().at(t), start = free.start();
		return new Light(free, (start.x() - clamp.x()) * Math.cos(free.angle(0))
			+ (start.y() - clamp.y()) * Math.sin(free.angle(0)));
	}

	/** The clamp, if it stays, where light usually begins: held elsewhere, all tips would be off. */
	private AnchorPath beginning(final List<Light> seen) {
		return course.anchor().range() > 0
			? course.anchor()
			: AnchorPath.still(
				RobustStatistics.upperMedian(seen.stream().map(l -> l.chain.start()).toList()),
				fits.size());
	}

	/**
	 * The same contours as long as the filament is on another course, fitted again: much less work
	 * than to find them anew, and where the length is hardly another one finds the same. What is too
	 * dear to be chosen stays as it was found. O(frames * fits * length).
	 *
	 * @param other the same line and fixed end, another constant length
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	FitPools withCourse(final FilamentCourse other, final Workers workers,
		final Progress progress) {
		final FitPools there = with(other, fits);
		return with(other,
			workers.map("Fitting the contours", progress, fits.size(), there::again));
	}

	private FitPools with(final FilamentCourse other, final List<List<Fit>> found) {
		return new FitPools(frames, light, other, sets, found, settings);
	}

	private List<Fit> again(final int t) {
		final FilamentFitter fitter = fitter(t);
		final double dearest = TrackTuning.COURSE_HOPELESS + Propagation.cheapest(fits.get(t));
		final FitPool pool = new FitPool();
		for (final Fit fit : fits.get(t)) {
			final Chain resized = fit.chain().resized(course.length().of(t)).divided(links());
			pool.add(fit.energy() < dearest
				? fitter.fit(resized, Optional.empty(), dearest)
				: fitter.price(resized));
		}
		return pool.fits();
	}

	/**
	 * The same, but in frames in which the fixed end jumped it is where their own picture has it.
	 * Set free, a contour of known length lies where the light is; a jump of less than three frames,
	 * or next to the movie's first or last frame, is seen by that alone. Not if each fit has a length
	 * of its own, as its ends are nowhere else then.
	 *
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	FitPools withJumps(final Workers workers, final Progress progress) {
		if (settings.freeLength())
			return this;
		final FreedEnds freed = freed(false, workers, progress);
		final SortedMap<Integer, Point> jumps = freed.jumps(width());
		if (jumps.isEmpty())
			return this;
		final FitPools moved = with(course.withAnchor(course.anchor().withJumps(jumps)), fits);
		return with(moved.course, workers.map(fits.size(),
			t -> jumps.containsKey(t) ? moved.jumped(t, freed.chain(t)) : fits.get(t)));
	}

	/**
	 * A fixed end that moves is once more followed through where contours begin that are not held:
	 * those that are held begin where it was thought to be. They may have any length, too: one that is
	 * not quite right moves no end then. One that was thought to stay is followed if the contours of
	 * most frames begin elsewhere and are better so than by chance: no farther than skeletons leave
	 * open, or farther and farther one way.
	 *
	 * @param doubtful whether little says that it moves, or stays
	 * @param mayDrift whether one that was thought to stay may go far
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	FilamentCourse withAnchorOfAll(final boolean doubtful, final boolean mayDrift,
		final Workers workers, final Progress progress) {
		final boolean still = course.anchor().range() == 0;
		if (still && (!doubtful || settings.freeLength()))
			return course;
		final FreedEnds freed = freed(!still, workers, progress);
		return still && !freed.areElsewhere(chance(), mayDrift)
			? course
			: course.withAnchor(course.anchor().refined(freed.chains()));
	}

	private FreedEnds freed(final boolean anyLength, final Workers workers,
		final Progress progress) {
		return new FreedEnds(workers.map("Setting the fixed end free", progress, fits.size(),
			t -> freed(t, anyLength)));
	}

	/** The cheapest contour of a frame, or the graph's best, if it begins where it likes. */
	private Optional<FreedEnds.Freed> freed(final int t, final boolean anyLength) {
		return fits.get(t).stream().min(Comparator.comparingDouble(Fit::energy)).map(best -> {
			final FilamentFitter free = fitter(t, Optional.empty(),
				settings.withFreeLength(anyLength || settings.freeLength()), links());
			Fit freed = free.fit(best.chain(), Optional.empty());
			final Point place = course.anchor().at(t);
			final Optional<Polyline> seen = sets.get(t).candidates().stream().findFirst()
				.map(ContourBuilder::smooth)
				.filter(c -> c.first().distanceTo(place) > TrackTuning.STILL_SKELETON);
			if (seen.isPresent()) {
				final FilamentFitter stiff = fitter(t, Optional.empty(),
					settings.roughAndStiff(FitSettings.START_STIFFNESS),
					FitProposals.stiffLinks(links()));
				final Chain start = new FitProposals(frames.get(t), course.in(t), links(), false)
					.start(seen.get());
				final Fit own = FreedEnds.rightWayRound(
					free.fit(FitProposals.bent(start, stiff), Optional.empty()), place, free);
				freed = own.energy() < freed.energy() ? own : freed;
			}
			return new FreedEnds.Freed(freed.chain(), freed.chain().start().distanceTo(place),
				free.price(best.chain()).energy() - freed.energy(),
				-freed.light() / freed.chain().length());
		});
	}

	private List<Fit> jumped(final int t, final Chain freed) {
		final FilamentFitter fitter = fitter(t);
		final Fit best = fitter.fit(freed, Optional.empty());
		final FitPool pool = new FitPool(List.of(best));
		for (final Fit fit : fits.get(t)) {
			pool.add(fitter.price(fit.chain()));
			pool.add(
				fitter.fit(fit.chain(), Optional.empty(), best.energy() + TrackTuning.HOPELESS));
		}
		return pool.fits();
	}

	/** @return the fits of a frame that are as the user said; further ones if none at hand is */
	List<Fit> restricted(final int t, final Restriction said) {
		final FitProposals proposals = new FitProposals(frames.get(t), course.in(t), links(),
			settings.freeLength());
		if (said.contour().isPresent())
			return proposals.of(said.contour().get(), fitter(t));
		final List<Fit> atHand = met(fits.get(t), said);
		return atHand.isEmpty()
			? met(proposals.of(sets.get(t), fitter(t),
				fitter(t, settings.roughAndStiff(FitSettings.START_STIFFNESS),
					FitProposals.stiffLinks(links())),
				said::isNearlyMetBy), said)
			: atHand;
	}

	private static List<Fit> met(final List<Fit> fits, final Restriction said) {
		return fits.stream().filter(f -> said.isMetBy(f.chain().contour())).toList();
	}

	/** @return what carries fits of a frame to its neighbours */
	Propagation propagation(final int width, final Progress progress) {
		return new Propagation(width, MotionPrice.learn(fits, course.anchor()), this::fitter, fits,
			new Propagation.Frames(course, settings.freeLength()), progress);
	}

	/**
	 * The same, and wherever two strands of a frame's likely contour may have been exchanged, the
	 * contour on which they are. Not if each fit has a length of its own, as then it tells little.
	 *
	 * @param workers threads
	 * @param progress asked whether to stop
	 */
	FitPools withExchanges(final Workers workers, final Progress progress) {
		FitPools pools = this;
		for (int round = 0; round < TrackTuning.EXCHANGE_ROUNDS && !settings.freeLength(); round++)
			pools = pools.exchanged(workers, progress);
		return pools;
	}

	private FitPools exchanged(final Workers workers, final Progress progress) {
		final TrellisPath path = FitTrellis
			.course(fits, course.anchor(), MotionPrice.learn(fits, course.anchor()), progress)
			.path();
		return with(course, workers.map("Exchanging strands", progress, fits.size(),
			t -> path.choice()[t] < 0 ? fits.get(t) : exchanged(t, path.choice()[t])));
	}

	private List<Fit> exchanged(final int t, final int chosen) {
		final Fit fit = fits.get(t).get(chosen);
		final double width = width();
		final double seen = TrackTuning.STRANDS_SEEN * width;
		final FitProposals proposals = new FitProposals(frames.get(t), course.in(t), links(),
			settings.freeLength());
		final List<Fit> all = new ArrayList<>(fits.get(t));
		for (final Polyline other : new StrandExchange(fit.chain(), width).contours()) {
			final Chain start = proposals.start(other);
			if (isNear(start, all, TrackTuning.STRANDS_SAME * width))
				continue;
			final Fit exchanged = fitter(t).fit(start, Optional.empty(),
				fit.energy() + TrackTuning.HOPELESS);
			if (exchanged.energy() < fit.energy() + TrackTuning.HOPELESS
				&& !isNear(exchanged.chain(), all, seen))
				all.add(exchanged);
		}
		return List.copyOf(all);
	}

	private static boolean isNear(final Chain chain, final List<Fit> fits, final double near) {
		return fits.stream().anyMatch(f -> f.chain().farthest(chain) < near);
	}
}
