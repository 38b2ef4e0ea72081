package io.github.knotresolver.ui.model;

import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.UnaryOperator;

import io.github.knotresolver.geometry.Drag;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.model.Alternative;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;

/**
 * A result under review: one looks at a filament in a frame, is told where to look next, and says
 * what is wrong; the whole movie is solved again in the background. What is said while a solve goes
 * on overtakes it. Before the movie was solved once, and after {@link #close()}, nothing can be said.
 * The result at rest is that of a run with {@link #said()} as its corrections, to
 * the byte.
 * <p>
 * Safe to use from several threads. Listeners are told after every change, by the thread that made
 * it: the caller's, or the solver's.
 */
public final class ReviewModel extends ResultView implements AutoCloseable {

	private static final String MORE_MEMORY = "give Java more (ImageJ: Edit > Options > Memory & Threads)";

	private final LatestAnswer answers;

	private EditHistory history;
	/** The history that the result belongs to. */
	private EditHistory solved;
	/** Whether the result is the solver's, so that words can follow. */
	private boolean ready;
	private Optional<String> problem = Optional.empty();
	private Optional<String> stage = Optional.empty();
	private boolean closed;

	/**
	 * Begins to solve.
	 *
	 * @param movie the movie
	 * @param solver answers for that movie; with no settings' constraints of its own
	 * @param said what was said before, such as the contents of {@code corrections.csv}
	 */
	public ReviewModel(final Movie movie, final Solver solver, final List<Constraint> said) {
		super(movie);
		this.answers = new LatestAnswer(solver, new Hearer());
		history = EditHistory.of(Edits.of(said));
		solved = history;
		solve();
	}

	private ReviewModel(final Tracks shown, final Solver solver, final boolean ready) {
		super(shown.movie());
		answers = new LatestAnswer(solver, new Hearer());
		history = EditHistory.of(Edits.of(shown.settings().constraints()));
		solved = history;
		show(shown, new TreeSet<>());
		this.ready = ready && history.present().said().equals(shown.settings().constraints());
		if (!this.ready)
			solve();
	}

	/**
	 * A result that is read is seen at once; it is solved in the background before words can follow.
	 *
	 * @param shown the result, with what was said of it in its settings
	 * @param solver answers for its movie; with no settings' constraints of its own
	 * @return its review
	 */
	public static ReviewModel finished(final Tracks shown, final Solver solver) {
		return new ReviewModel(shown, solver, false);
	}

	/**
	 * A result that a solver gave just now; words can follow at once.
	 *
	 * @param shown the result, with what was said of it in its settings
	 * @param solver the one that gave it
	 * @return its review
	 */
	public static ReviewModel live(final Tracks shown, final Solver solver) {
		return new ReviewModel(shown, solver, true);
	}

	/** @return whether words can follow: the movie has been solved */
	public synchronized boolean isReady() {
		return ready;
	}

	/** @param place the contour of this frame passes here, in pixels */
	public void through(final Point place) {
		say(w -> w.through(place));
	}

	/** @param place the tip of this frame's contour is here, in pixels */
	public void tip(final Point place) {
		say(w -> w.tip(place));
	}

	/**
	 * @param drag this frame's contour, as it is held
	 * @param place where it was let go, in pixels
	 */
	public void drag(final Drag drag, final Point place) {
		say(w -> w.dragged(drag, place));
	}

	/** @param contour that of this frame, fixed end first, in pixels */
	public void contour(final Polyline contour) {
		say(w -> new Constraint(filament(), frame(), Kind.CONTOUR, contour));
	}

	/**
	 * Contours that may have been changed elsewhere, such as in the ROI Manager; all that are not as
	 * they are shown are said at once.
	 *
	 * @param contours whole contours, in pixels
	 * @return how many are otherwise
	 */
	public int takeOver(final List<Constraint> contours) {
		final List<Constraint> other = tracks()
			.map(t -> contours.stream().filter(c -> Changes.isOther(t, c)).toList())
			.orElse(List.of());
		edit(e -> {
			Edits next = e;
			for (final Constraint c : other)
				next = next.with(c);
			return next;
		});
		return other.size();
	}

	/** The contour that is shown is wrong; nothing if there is none. */
	public void refuse() {
		shown().flatMap(Observation::contour)
			.ifPresent(c -> say(w -> new Constraint(filament(), frame(), Kind.NOT, c)));
	}

	/** @param index of an alternative, from 0, that is right; nothing if there is none of that index */
	public void take(final int index) {
		final List<Alternative> all = alternatives();
		if (index >= 0 && index < all.size())
			contour(all.get(index).contour());
	}

	private void say(final Function<Words, Constraint> word) {
		edit(e -> e.with(word.apply(words())));
	}

	private Words words() {
		return new Words(tracks().orElseThrow(), track().orElseThrow(), frame());
	}

	/**
	 * From this frame on, the filament is exchanged with another one; of the same two in the same
	 * frame again, it is not. Only while nothing is worked out.
	 *
	 * @param other number of that filament; one that there is not changes nothing
	 */
	public void exchange(final int other) {
		edit(e -> {
			if (stage.isPresent())
				throw new UserException(
					"Filaments can be exchanged as soon as the last correction is followed.");
			return tracks().orElseThrow().filaments().stream()
				.filter(f -> f.id() == other && other != filament()).findFirst()
				.map(f -> e.exchanging(words().exchanged(f), other)).orElse(e);
		});
	}

	/** Takes back all that was said about this filament in this frame, but not an exchange. */
	public void withdraw() {
		edit(e -> e.without(new Edits.Place(filament(), frame())));
	}

	/** What is shown in this frame is right. */
	public void accept() {
		edit(e -> isChecked(frame()) ? e : e.with(words().accepted()));
	}

	private void edit(final UnaryOperator<Edits> change) {
		synchronized (this) {
			if (!ready || closed || track().isEmpty())
				return;
			problem = Optional.empty();
			try {
				final Edits next = change.apply(history.present());
				if (next.equals(history.present()))
					return;
				moveTo(history.with(next));
			} catch (final UserException e) {
				problem = Optional.of(e.getMessage());
			}
		}
		tell();
	}

	/** @return whether there is a step to be undone */
	public synchronized boolean canUndo() {
		return history.canUndo();
	}

	/** @return whether there is a step to be done again */
	public synchronized boolean canRedo() {
		return history.canRedo();
	}

	/** Goes back one step; nothing at the first. */
	public void undo() {
		walk(EditHistory::undone);
	}

	/** Does again what was undone last; nothing if there is none. */
	public void redo() {
		walk(EditHistory::redone);
	}

	private void walk(final UnaryOperator<EditHistory> step) {
		synchronized (this) {
			if (closed)
				return;
			problem = Optional.empty();
			moveTo(step.apply(history));
		}
		tell();
	}

	private void moveTo(final EditHistory next) {
		final boolean same = next.present().deciding().equals(history.present().deciding());
		history = next;
		if (same)
			saying(said());
		if (!same)
			solve();
		else if (stage.isEmpty())
			solved = history;
	}

	private void solve() {
		stage = Optional.of("Solving");
		answers.ask(history.present().deciding());
	}

	/** Hears of what was asked; an answer to what is not said any more is nothing. */
	private final class Hearer implements LatestAnswer.Asker {

		@Override
		public void answered(final List<Constraint> said, final Tracks answer) {
			change(said, () -> {
				show(answer.saying(said()), tracks().filter(t -> ready)
					.map(before -> Changes.between(before, answer)).orElse(new TreeSet<>()));
				ready = true;
				solved = history;
				rest();
			});
		}

		/** What cannot be followed is taken back, with the reason. */
		@Override
		public void failed(final List<Constraint> said, final Throwable why) {
			change(said, () -> {
				problem = Optional.of(Failure.of(why, MORE_MEMORY).sentence());
				history = solved;
				saying(said());
				rest();
			});
		}

		@Override
		public void worked(final List<Constraint> said, final String what) {
			if (!stage().equals(Optional.of(what)))
				change(said, () -> stage = Optional.of(what));
		}

		private void change(final List<Constraint> said, final Runnable change) {
			synchronized (ReviewModel.this) {
				if (stage.isEmpty() || !said.equals(history.present().deciding()))
					return;
				change.run();
			}
			tell();
		}
	}

	private void rest() {
		stage = Optional.empty();
		notifyAll();
	}

	/** @return what is being worked out in the background; empty at rest */
	public synchronized Optional<String> stage() {
		return stage;
	}

	/** @return why the last word could not be followed, one sentence; empty if it was */
	public synchronized Optional<String> problem() {
		return problem;
	}

	/** @return all that was said, as {@code corrections.csv} holds it */
	public synchronized List<Constraint> said() {
		return history.present().said();
	}

	/**
	 * Waits until nothing is worked out any more.
	 *
	 * @return the result, which belongs to {@link #said()}
	 * @throws UserException if there is none, in one sentence
	 * @throws InterruptedException if the thread is asked to stop
	 */
	public synchronized Tracks atRest() throws InterruptedException {
		while (stage.isPresent())
			wait();
		return tracks().filter(t -> ready).orElseThrow(() -> new UserException(
			problem.orElse("The review was closed before there was a result.")));
	}

	/** Stops the work in the background. */
	@Override
	public void close() {
		synchronized (this) {
			closed = true;
			answers.close();
			rest();
		}
	}
}
