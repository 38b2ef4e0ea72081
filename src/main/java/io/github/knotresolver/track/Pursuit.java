
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.fit.SceneWindow;
import io.github.knotresolver.progress.Workers;

/**
 * Follows one filament from frame to frame, in one direction of time, with several hypotheses:
 * where its leading end goes is often open for some frames, and the frames after them tell. The
 * rest of a glider is where it was, a little farther along its own track, however tightly it is
 * wound up. The other filaments are drawn as they are known.
 */
final class Pursuit {

	/** A glider may be faster or slower by so much from frame to frame (pixels). */
	static final double[] CHANGES = {0, -1, 1, -2, 2};

	/** An end that turns may be so much farther than it seems (pixels). */
	private static final double[] AHEAD = {0, 1.5, 3};

	/** Lengths of ends that are grown anew (links). */
	private static final int[] TIPS = {2, 4, 8};

	private final SceneLine line;
	private final FitSettings rigid;
	private final FitSettings loose;
	private final ScenePass pass;
	private final int filament;
	private final boolean bendsOnce;

	/**
	 * A course up to a frame.
	 *
	 * @param chain the filament there
	 * @param sum what the course costs
	 * @param before the course up to the frame before; null in the first one
	 */
	record Course(Chain chain, double sum, Course before) {
	}

	/**
	 * @param line what a line looks like, and the frames
	 * @param weights of the fit
	 * @param pass all filaments
	 * @param filament the one that is followed
	 * @param bendsOnce whether a course pays for a bend when the leading end makes it; otherwise in
	 *          every frame
	 */
	Pursuit(final SceneLine line, final SceneWeights weights, final ScenePass pass,
		final int filament, final boolean bendsOnce) {
		this.line = line;
		rigid = weights.predicted();
		loose = weights.searched();
		this.pass = pass;
		this.filament = filament;
		this.bendsOnce = bendsOnce;
	}

	/**
	 * The courses that go on to a frame, the cheapest first; O(courses).
	 *
	 * @param courses those up to the frame before, at least one
	 * @param t index of the frame
	 */
	List<Course> next(final List<Course> courses, final int t, final Workers workers) {
		final List<Course> all = new ArrayList<>();
		workers.map(courses.size(), i -> following(courses.get(i), t)).forEach(all::addAll);
		all.sort(Comparator.comparingDouble(Course::sum));
		final List<Course> kept = new ArrayList<>();
		for (final Course c : all)
			if (kept.size() < SceneTuning.PURSUIT_MOST
				&& c.sum <= all.get(0).sum + SceneTuning.PURSUIT_MARGIN && kept.stream()
					.noneMatch(k -> k.chain.farthest(c.chain) < SceneTuning.PURSUIT_SAME))
				kept.add(c);
		return kept;
	}

	private List<Course> following(final Course course, final int t) {
		final List<Chain> others = new ArrayList<>(pass.chains().get(t));
		others.remove(filament);
		final Scene scene = line.scene(t, others);
		final List<Chain> predictions = predictions(course);
		final SceneWindow window = scene.window(predictions);
		final Chain expected = window.cheapest(predictions, loose);
		final List<Course> found = new ArrayList<>();
		final Fit first = window.fit(expected, Optional.of(expected), rigid);
		final Fit usual = window.fit(first.chain(), Optional.of(expected), loose);
		found.add(course(course, usual, expected, expected));
		for (final Chain turned : turned(window, course, expected, usual.energy()))
			found.add(
				course(course, window.fit(turned, Optional.of(turned), loose), turned, expected));
		for (final Chain held : promising(window,
			HeldEnd.shapes(course.chain, course.chain.slide(expected)), usual.energy(),
			SceneTuning.HELD_FITTED))
			found.add(course(course, window.fit(held, Optional.of(held), loose), held, held));
		return found;
	}

	/**
	 * @param expected from where it was fitted
	 * @param slid where it was, a little farther along its own track
	 */
	private Course course(final Course before, final Fit fit, final Chain expected,
		final Chain slid) {
		final double bending = bendsOnce
			? loose.stiffness() * newBends(fit.chain(), slid)
			: fit.energy() - fit.light();
		return new Course(fit.chain(), before.sum + fit.light() + bending
			+ loose.memory() * expected.length() * fit.chain().squaredTurn(expected), before);
	}

	/** The sum of squared turns from link to link beyond those before, by the length of a link. */
	private static double newBends(final Chain chain, final Chain before) {
		double sum = 0;
		for (int i = 1; i < chain.links(); i++) {
			final double more = chain.angle(i) - chain.angle(i - 1) - before.angle(i)
				+ before.angle(i - 1);
			sum += more * more;
		}
		return sum / chain.linkLength();
	}

	private static List<Chain> predictions(final Course course) {
		final Chain here = course.chain;
		final List<Chain> all = new ArrayList<>(List.of(here));
		final double speed = speed(course);
		if (course.before != null)
			all.add(here.continued(course.before.chain));
		for (final double by : CHANGES)
			all.add(here.slid(speed + by));
		return all;
	}

	private static double speed(final Course course) {
		return course.before == null ? 0 : course.before.chain.slide(course.chain);
	}

	/** The filament with its leading end grown anew, in the most promising ways. */
	private List<Chain> turned(final SceneWindow window, final Course course, final Chain expected,
		final double usual) {
		final double speed = speed(course);
		final List<Fit> promising = new ArrayList<>();
		for (final double by : AHEAD)
			for (final int tip : TIPS) {
				if (speed > -SceneTuning.PURSUIT_SLOW)
					for (final Chain c : window.regrown(expected.slid(by), tip, loose))
						promising.add(window.price(c, loose));
				if (speed < SceneTuning.PURSUIT_SLOW)
					for (final Chain c : window.regrown(expected.slid(-by).reversed(), tip, loose))
						promising.add(window.price(c.reversed(), loose));
			}
		return promising(promising, usual, SceneTuning.PURSUIT_FITTED);
	}

	private List<Chain> promising(final SceneWindow window, final List<Chain> chains,
		final double usual, final int most) {
		return promising(chains.stream().map(c -> window.price(c, loose)).toList(), usual, most);
	}

	/** The cheapest few that are not much dearer than what is usual. */
	private static List<Chain> promising(final List<Fit> fits, final double usual, final int most) {
		return fits.stream().filter(f -> f.energy() < usual + SceneTuning.PURSUIT_PROMISING)
			.sorted(Comparator.comparingDouble(Fit::energy)).limit(most).map(Fit::chain).toList();
	}
}
