package io.github.knotresolver.ui.model;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.model.Alternative;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.FilamentTrack;
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
public final class ReviewModel implements AutoCloseable {

	private static final String MORE_MEMORY = "give Java more (ImageJ: Edit > Options > Memory & Threads)";

	private final Movie movie;
	private final LatestAnswer answers;
	private final List<Runnable> listeners = new CopyOnWriteArrayList<>();

	private EditHistory history;
	/** The history that the result belongs to. */
	private EditHistory solved;
	private Optional<Tracks> tracks = Optional.empty();
	private SortedSet<Edits.Place> changed = new TreeSet<>();
	private Optional<String> problem = Optional.empty();
	private Optional<String> stage = Optional.empty();
	private int frame = 1;
	private int filament = 1;
	private boolean closed;

	/**
	 * Begins to solve.
	 *
	 * @param movie the movie
	 * @param solver answers for that movie; with no settings' constraints of its own
	 * @param said what was said before, such as the contents of {@code corrections.csv}
	 */
	public ReviewModel(final Movie movie, final Solver solver, final List<Constraint> said) {
		this.movie = movie;
		this.answers = new LatestAnswer(solver, new Hearer());
		history = EditHistory.of(Edits.of(said));
		solved = history;
		solve();
	}

	/** @return the movie under review */
	public Movie movie() {
		return movie;
	}

	/** @param listener told after every change */
	public void listen(final Runnable listener) {
		listeners.add(listener);
	}

	private void tell() {
		listeners.forEach(Runnable::run);
	}

	/** @return the frame that is looked at, from 1 */
	public synchronized int frame() {
		return frame;
	}

	/** @param wanted a frame, from 1; beyond the movie's ends, the nearest */
	public void goTo(final int wanted) {
		synchronized (this) {
			final int next = Math.max(1, Math.min(movie.size(), wanted));
			if (next == frame)
				return;
			frame = next;
		}
		tell();
	}

	/** @return the number of the filament that is looked at, from 1 */
	public synchronized int filament() {
		return filament;
	}

	/** @param wanted number of a filament; one that there is not changes nothing */
	public void choose(final int wanted) {
		synchronized (this) {
			if (tracks.isEmpty()
				|| tracks.get().filaments().stream().noneMatch(f -> f.id() == wanted))
				return;
			filament = wanted;
		}
		tell();
	}

	/** @return the result; empty until the movie has been solved once */
	public synchronized Optional<Tracks> tracks() {
		return tracks;
	}

	/** @return the filament that is looked at, in all frames; empty likewise */
	public synchronized Optional<FilamentTrack> track() {
		return tracks
			.flatMap(t -> t.filaments().stream().filter(f -> f.id() == filament).findFirst());
	}

	/** @return what was found of the filament in the frame; empty likewise */
	public synchronized Optional<Observation> shown() {
		return track().map(t -> t.frames().get(frame - 1));
	}

	/** @return other contours for this frame, cheapest first; none until the movie is solved */
	public synchronized List<Alternative> alternatives() {
		return shown().map(Observation::alternatives).orElse(List.of());
	}

	/** @return the confidence of each frame, 0..1; NaN where there is no contour */
	public synchronized double[] confidences() {
		final double[] all = new double[movie.size()];
		Arrays.setAll(all,
			t -> track().map(f -> f.frames().get(t).confidence()).orElse(Double.NaN));
		return all;
	}

	/** @return the frames to look at, the least certain first; without those that were accepted */
	public synchronized List<Integer> doubtful() {
		return track().map(t -> Doubts.of(t, history.present())).orElse(List.of());
	}

	/** Goes to the next less certain frame; from any other frame to the least certain. */
	public void nextDoubtful() {
		step(1);
	}

	/** Goes to the frame before in the order of doubt; from any other frame to the most certain. */
	public void previousDoubtful() {
		step(-1);
	}

	private void step(final int by) {
		goTo(Doubts.step(doubtful(), frame(), by));
	}

	/** @param place the contour of this frame passes here, in pixels */
	public void through(final Point place) {
		say(Kind.THROUGH, () -> Optional.of(Polyline.of(List.of(place))));
	}

	/** @param place the tip of this frame's contour is here, in pixels */
	public void tip(final Point place) {
		say(Kind.TIP, () -> Optional.of(Polyline.of(List.of(place))));
	}

	/** @param contour that of this frame, fixed end first, in pixels */
	public void contour(final Polyline contour) {
		say(Kind.CONTOUR, () -> Optional.of(contour));
	}

	/** The contour that is shown is wrong; nothing if there is none. */
	public void refuse() {
		say(Kind.NOT, () -> shown().flatMap(Observation::contour));
	}

	/** @param index of an alternative, from 0, that is right; nothing if there is none of that index */
	public void take(final int index) {
		say(Kind.CONTOUR, () -> alternatives().stream().skip(Math.max(0, index)).findFirst()
			.filter(a -> index >= 0).map(Alternative::contour));
	}

	private void say(final Kind kind, final Supplier<Optional<Polyline>> shape) {
		edit(e -> shape.get().map(s -> e.with(new Constraint(filament, frame, kind, s))).orElse(e));
	}

	/** Takes back all that was said about this filament in this frame. */
	public void withdraw() {
		edit(e -> e.without(new Edits.Place(filament, frame)));
	}

	/** What is shown in this frame is right. */
	public void accept() {
		edit(e -> e.accepting(new Edits.Place(filament, frame)));
	}

	private void edit(final UnaryOperator<Edits> change) {
		synchronized (this) {
			if (tracks.isEmpty() || closed)
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

	/** @return whether a frame was accepted, or its contour is as a person said */
	public synchronized boolean isChecked(final int wanted) {
		return track().filter(t -> Doubts.isChecked(t, wanted, history.present())).isPresent();
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
		final boolean same = next.present().said().equals(history.present().said());
		history = next;
		if (!same)
			solve();
		else if (stage.isEmpty())
			solved = history;
	}

	private void solve() {
		stage = Optional.of("Solving");
		answers.ask(history.present().said());
	}

	/** Hears of what was asked; an answer to what is not said any more is nothing. */
	private final class Hearer implements LatestAnswer.Asker {

		@Override
		public void answered(final List<Constraint> said, final Tracks answer) {
			change(said, () -> {
				changed = tracks.map(before -> Changes.between(before, answer))
					.orElse(new TreeSet<>());
				tracks = Optional.of(answer);
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
				if (stage.isEmpty() || !said.equals(history.present().said()))
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

	/** @return the frames in which the last answer shows the filament otherwise than the one before */
	public synchronized SortedSet<Integer> changed() {
		final SortedSet<Integer> frames = new TreeSet<>();
		changed.stream().filter(p -> p.filament() == filament).forEach(p -> frames.add(p.frame()));
		return frames;
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
		return tracks.orElseThrow(() -> new UserException(
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
