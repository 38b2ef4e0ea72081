package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;

import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * Answers for one movie, again and again. What the user says of a frame leaves fewer fits
 * there and brings up others in its neighbours, as far as they are new; each such
 * consequence hangs on that frame alone, and is kept. So the answer is the same in whatever
 * order things were said, and the same as if all had been said at the beginning; only the
 * cheapest way through all fits is looked for anew.
 */
public final class FitSolver {

	private final FitPools pools;
	private final Map<Restriction, Consequence> known = new ConcurrentHashMap<>();
	private final List<Map<Fit, FitLook>> looks = new ArrayList<>();
	/** The movie if nothing was said, once it is solved: several ask for that. */
	private Optional<FitTrellis.Solved> unsaid = Optional.empty();

	FitSolver(final FitPools pools) {
		this.pools = pools;
		pools.frames().forEach(f -> looks.add(new IdentityHashMap<>()));
	}

	/** The fits that a restriction leaves in its frame, and those that it brings up elsewhere. */
	private record Consequence(List<Fit> left, SortedMap<Integer, List<Fit>> elsewhere) {
	}

	/**
	 * Chooses a contour for each frame. Not for several threads at once.
	 *
	 * @param constraints what the user said of the filament, in any order
	 * @param workers threads
	 * @param progress told how far the work is, and asked whether to stop
	 * @return one contour a frame
	 */
	public Track solve(final List<Constraint> constraints, final Workers workers,
		final Progress progress) {
		final SortedMap<Integer, Restriction> said = byFrame(constraints);
		consider(said, workers, progress);
		final FitTrellis.Solved solved = solved(said, progress);
		final FilamentCourse course = pools.course();
		final List<String> notes = new ArrayList<>(
			List.of("Line model: " + course.estimate().model() + "."));
		final LengthCourse lengths = course.length().settled(solved.lengths());
		notes.addAll(course.withLength(lengths).notes(pools.frames()));
		final FilamentEstimate estimate = course.estimate();
		return new Track(estimate.fixedEnd(), estimate.length(), estimate.lengthError(),
			GuessedLength.doubtedAtBreak(
				GuessedLength.doubted(
					StrayStart.doubted(TurnedRound.doubted(solved.frames()),
						estimate.model().sigma()),
					estimate, pools.light().stream().anyMatch(NormalizedFrame::isClipped)),
				lengths, estimate.model()),
			notes);
	}

	/**
	 * Takes the confidence off contours whose tip may be off because the line is wide.
	 *
	 * @param track that this solved
	 * @param binning edge of a pixel in pixels of the movie
	 * @return the same contours
	 */
	public Track doubtedIfWide(final Track track, final double binning) {
		final LineModel model = pools.course().estimate().model();
		return track.withFrames(TipBeside.ofLine(model.sigma()).doubted(track.frames(),
			pools.course().noise() / model.atTip(), TrackTuning.WRONG / binning));
	}

	/**
	 * What can be seen of the contours that are chosen if the user says nothing.
	 *
	 * @param progress asked whether to stop
	 * @return for each frame; empty where there is no contour
	 */
	public List<Optional<FitEvidence>> evidence(final Progress progress) {
		return solved(progress).evidence();
	}

	/**
	 * The movie with the length that all frames say together, if that is surely another and explains
	 * more; otherwise as it is. A fit goes on a little when it is made again, so that what is known
	 * is fitted again, too, before it is compared.
	 */
	FitSolver withLengthOfAll(final Workers workers, final Progress progress) {
		return pools.lengthOfAll(solved(progress).frames(), workers)
			.map(course -> again(course, workers, progress))
			.filter(other -> other.isCheaperThan(this, progress)).map(other -> {
				final FitSolver same = again(pools.course(), workers, progress);
				return other.isCheaperThan(same, progress) ? other : same;
			}).orElse(this);
	}

	private FitSolver again(final FilamentCourse course, final Workers workers,
		final Progress progress) {
		return new FitSolver(
			pools.withCourse(course, workers, progress).withExchanges(workers, progress));
	}

	private boolean isCheaperThan(final FitSolver other, final Progress progress) {
		return solved(progress).price() < other.solved(progress).price();
	}

	/** Whether an estimate's length or fixed end is noticeably another than here. */
	boolean isOtherThan(final FilamentEstimate other) {
		final FilamentEstimate known = pools.course().estimate();
		return Math.abs(other.length() / known.length() - 1) > TrackTuning.NOTICEABLE_LENGTH
			|| other.fixedEnd().distanceTo(known.fixedEnd()) > TrackTuning.STILL_END;
	}

	/** The movie's price in the frames' units of light squared, by which lines can be compared. */
	double price(final Progress progress) {
		final double strand = pools.course().estimate().amplitude();
		return solved(progress).price() * strand * strand;
	}

	/** The movie if the user says nothing. */
	FitTrellis.Solved solved(final Progress progress) {
		return solved(new TreeMap<>(), progress);
	}

	private FitTrellis.Solved solved(final SortedMap<Integer, Restriction> said,
		final Progress progress) {
		if (said.isEmpty() && unsaid.isPresent())
			return unsaid.get();
		final FitTrellis.Solved solved = new FitTrellis(pools.frames(), pools.light(),
			pools.course(), fits(said), pools.sets(), this::look, pools.settings().freeLength())
			.solve(said, progress);
		if (said.isEmpty())
			unsaid = Optional.of(solved);
		return solved;
	}

	private SortedMap<Integer, Restriction> byFrame(final List<Constraint> constraints) {
		final double sigma = pools.course().estimate().model().sigma();
		final SortedMap<Integer, Restriction> said = new TreeMap<>();
		for (int t = 0; t < pools.frames().size(); t++) {
			final int frame = pools.frames().get(t).frame();
			final List<Constraint> here = Constraint
				.sorted(constraints.stream().filter(c -> c.frame() == frame).toList());
			if (!here.isEmpty())
				said.put(t, new Restriction(here, sigma));
		}
		return said;
	}

	/** Works out what is new. */
	private void consider(final SortedMap<Integer, Restriction> said, final Workers workers,
		final Progress progress) {
		final List<Integer> news = said.keySet().stream()
			.filter(t -> !known.containsKey(said.get(t))).toList();
		workers.map("Thinking over what was said", progress, news.size(), i -> known
			.put(said.get(news.get(i)), consequence(news.get(i), said.get(news.get(i)), progress)));
	}

	private Consequence consequence(final int t, final Restriction restriction,
		final Progress progress) {
		final List<Fit> left = pools.restricted(t, restriction);
		final Propagation propagation = pools.propagation(TrackTuning.HYPOTHESES, progress);
		final SortedMap<Integer, List<Fit>> elsewhere = new TreeMap<>(
			propagation.spread(t, 1, left, pools.fits()));
		elsewhere.putAll(propagation.spread(t, -1, left, pools.fits()));
		return new Consequence(left, elsewhere);
	}

	/** The fits of all frames as they are after all was said. */
	private List<List<Fit>> fits(final SortedMap<Integer, Restriction> said) {
		final List<List<Fit>> fits = new ArrayList<>();
		for (int t = 0; t < pools.frames().size(); t++) {
			final Restriction here = said.get(t);
			final FitPool pool = new FitPool(
				here == null ? pools.fits().get(t) : known.get(here).left);
			if (here == null || here.contour().isEmpty())
				for (final Restriction other : said.values())
					known.get(other).elsewhere.getOrDefault(t, List.of()).stream()
						.filter(f -> here == null || here.isMetBy(f.chain().contour()))
						.forEach(pool::add);
			fits.add(pool.fits());
		}
		return fits;
	}

	private FitLook look(final int t, final Fit fit) {
		return looks.get(t).computeIfAbsent(fit, f -> FitLook.at(pools.frames().get(t),
			pools.light().get(t), pools.course().estimate().model(), f.chain()));
	}
}
