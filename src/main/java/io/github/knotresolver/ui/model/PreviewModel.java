package io.github.knotresolver.ui.model;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;

import io.github.knotresolver.io.Failure;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.FilamentChoice;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.MovieSource;
import io.github.knotresolver.session.FrameLook;
import io.github.knotresolver.session.FramePreview;

/**
 * What a person sees while values are still being chosen: one frame as the program sees it, in one
 * line of words, and what the check before the work says of the movie. All is worked out in the
 * background; a new question overtakes the one before, and what the movie tells by itself is kept as
 * long as the questions are about the same movie.
 * <p>
 * Safe to use from several threads. Listeners are told after every change, by the thread that made
 * it.
 */
public final class PreviewModel implements AutoCloseable {

	private static final String MORE_MEMORY = "give Java more (ImageJ: Edit > Options > Memory & Threads)";

	private static final FramePreview.Check NOTHING = new FramePreview.Check(List.of(),
		Optional.empty());

	/**
	 * What is asked.
	 *
	 * @param source of the movie; two questions with the same one are about the same pixels
	 * @param options as far as they are known
	 * @param frame that is looked at, from 1
	 */
	public record Question(MovieSource source, RunOptions options, int frame) {
	}

	/** A movie that was read, and from what. */
	private record Known(MovieSource source, InputOptions input, Movie movie,
		FramePreview preview) {

		boolean isOf(final Question question) {
			return source == question.source && input.equals(question.options.input());
		}
	}

	private final LatestWork looking = new LatestWork("KnotResolver preview"),
		checking = new LatestWork("KnotResolver check");
	private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
	private Optional<Question> asked = Optional.empty();
	private Optional<Known> known = Optional.empty();
	private Optional<FrameLook> look = Optional.empty();
	private String line = "";
	private FramePreview.Check check = NOTHING;
	private boolean working, checkGoesOn;

	/** What the check was about last: source, input and settings. */
	private List<Object> checked = List.of();

	/** @param listener told after every change */
	public void listen(final Runnable listener) {
		listeners.add(listener);
	}

	private void tell() {
		listeners.forEach(Runnable::run);
	}

	/**
	 * Asks; returns at once. The same question again changes nothing.
	 *
	 * @param question what is asked
	 */
	public void ask(final Question question) {
		synchronized (this) {
			if (asked.filter(question::equals).isPresent())
				return;
			if (asked.filter(a -> a.source == question.source).isEmpty())
				clear();
			asked = Optional.of(question);
			working = true;
		}
		looking.start(progress -> answer(question, progress));
		tell();
	}

	/** Nothing is asked any more, and nothing is shown. */
	public void off() {
		synchronized (this) {
			looking.stop();
			checking.stop();
			asked = Optional.empty();
			clear();
			notifyAll();
		}
		tell();
	}

	private void clear() {
		look = Optional.empty();
		line = "";
		check = NOTHING;
		checked = List.of();
		working = false;
		checkGoesOn = false;
	}

	private void answer(final Question question, final Progress progress) {
		Optional<FrameLook> seen = Optional.empty();
		String words;
		try {
			final Known of = known(question, progress);
			final Settings settings = question.options.settings(of.movie, List.of());
			final int frame = Math.max(1, Math.min(of.movie.size(), question.frame));
			check(question, settings, of.preview);
			seen = Optional.of(of.preview.look(informed(settings), frame, progress));
			words = LookWords.line(seen.get(), of.movie.calibration());
		} catch (final CancelledException e) {
			throw e;
		} catch (final RuntimeException | Error e) {
			// Of an image that was closed meanwhile nobody wants to know.
			progress.checkCancelled();
			words = Failure.of(e, MORE_MEMORY).sentence();
		}
		show(progress, seen, words);
	}

	/** What the check has found is as good as told, unless a person says otherwise. */
	private synchronized Settings informed(final Settings settings) {
		return settings.fixedEnd().isPresent() || check.fixedEnd().isEmpty()
			|| settings.filaments() == FilamentChoice.ALL
				? settings
				: settings.edit().fixedEnd(check.fixedEnd()).build();
	}

	private void show(final Progress progress, final Optional<FrameLook> seen, final String words) {
		synchronized (this) {
			progress.checkCancelled();
			look = seen;
			line = words;
			working = false;
			notifyAll();
		}
		tell();
	}

	private Known known(final Question question, final Progress progress) {
		synchronized (this) {
			if (known.filter(k -> k.isOf(question)).isPresent())
				return known.get();
		}
		final Movie movie = question.source.read(question.options.input(), progress);
		final Known fresh = new Known(question.source, question.options.input(), movie,
			new FramePreview(movie));
		synchronized (this) {
			progress.checkCancelled();
			known = Optional.of(fresh);
		}
		return fresh;
	}

	/** The check does not depend on the frame that is looked at, nor on how contours are resolved. */
	private void check(final Question question, final Settings settings,
		final FramePreview preview) {
		final List<Object> about = List.of(question.source, question.options.input(),
			settings.segmentation(), settings.cleaning(), settings.frames(),
			settings.ignoreFrames(), settings.region(), settings.isPublished());
		synchronized (this) {
			if (about.equals(checked))
				return;
			checked = about;
			checkGoesOn = true;
		}
		checking.start(progress -> {
			FramePreview.Check found;
			try {
				found = preview.check(settings, progress);
			} catch (final CancelledException e) {
				throw e;
			} catch (final RuntimeException | Error e) {
				progress.checkCancelled();
				found = new FramePreview.Check(List.of(Failure.of(e, MORE_MEMORY).sentence()),
					Optional.empty());
			}
			tell(about, found, progress);
		});
	}

	private void tell(final List<Object> about, final FramePreview.Check found,
		final Progress progress) {
		final Optional<Question> again;
		synchronized (this) {
			progress.checkCancelled();
			if (!about.equals(checked))
				return;
			again = found.fixedEnd().equals(check.fixedEnd()) ? Optional.empty() : asked;
			check = found;
			checkGoesOn = false;
			working |= again.isPresent();
			notifyAll();
		}
		again.ifPresent(q -> looking.start(p -> answer(q, p)));
		tell();
	}

	/** @return the last answer, which may be that to an earlier question; empty if there is none */
	public synchronized Optional<FrameLook> look() {
		return look;
	}

	/** @return the last answer in one line of words, or why there is none; empty before the first */
	public synchronized String line() {
		return line;
	}

	/** @return what the check says of the movie, one sentence each; none until it is done */
	public synchronized List<String> checks() {
		return check.notes();
	}

	/** @return whether the last question has no answer yet */
	public synchronized boolean isWorking() {
		return working;
	}

	/**
	 * Waits for the answer to the last question, and for the check.
	 *
	 * @return its look; empty if there is none, for the reason in {@link #line()}
	 * @throws InterruptedException if the thread is asked to stop
	 */
	public synchronized Optional<FrameLook> atRest() throws InterruptedException {
		while (working || checkGoesOn)
			wait();
		return look;
	}

	/** Stops the work in the background, and lets go of the movie. */
	@Override
	public void close() {
		off();
		looking.close();
		checking.close();
		synchronized (this) {
			known = Optional.empty();
			notifyAll();
		}
	}
}
