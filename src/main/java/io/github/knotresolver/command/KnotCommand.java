package io.github.knotresolver.command;

import java.io.IOException;
import java.util.Optional;
import java.util.function.BooleanSupplier;

import org.scijava.app.StatusService;
import org.scijava.command.ContextCommand;
import org.scijava.log.LogService;
import org.scijava.plugin.Parameter;

import ij.IJ;
import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.FormGroups;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.ui.FormCompanion;

/**
 * What all Commands share: values are checked, progress is shown, and input
 * that cannot be used cancels the Command with one sentence as the reason.
 * They run with or without a SciJava context.
 */
abstract class KnotCommand extends ContextCommand {

	/** How memory is given in ImageJ. */
	static final String MORE_MEMORY = "give ImageJ more with Edit > Options > Memory & Threads";

	@Parameter(required = false)
	private LogService log;

	@Parameter(required = false)
	private StatusService status;

	private Optional<Failure> failure = Optional.empty();
	private boolean watched;

	@Override
	public final void run() {
		try (CommandProgress progress = new CommandProgress(status, this::isCanceled)) {
			check();
			Cancellation.during(progress, () -> {
				work(progress);
				return null;
			});
		} catch (final RuntimeException | IOException | Error e) {
			end(Failure.of(e, MORE_MEMORY));
		}
	}

	private void end(final Failure ended) {
		failure = Optional.of(ended);
		if (ended.kind() == Failure.Kind.CANCELLED)
			cancel(ended.sentence());
		else
			refuse(ended.sentence());
	}

	/** @return why the last run ended early; empty if it did not */
	final Optional<Failure> failure() {
		return failure;
	}

	/**
	 * Checks what can be known of the values before the work, quickly: a dialog stays open until
	 * this succeeds.
	 *
	 * @throws UserException if they cannot be used, in one sentence
	 */
	void check() {
		Form.of(this).check();
	}

	/**
	 * Does the work.
	 *
	 * @throws UserException if the input cannot be used, in one sentence
	 * @throws CancelledException if the user asked to stop
	 * @throws IOException if a file cannot be written
	 */
	abstract void work(Progress progress) throws IOException;

	/**
	 * Asks a person for what only the input shows to be missing. Never called in
	 * macros, nor without a display.
	 *
	 * @return whether to go on
	 */
	boolean askForMissing() {
		return true;
	}

	/** A person has started it from its dialog, and may see windows of its work. */
	final void watch() {
		watched = true;
	}

	/** @return whether a person looks on */
	final boolean isWatched() {
		return watched;
	}

	/** @return how its fields are put before a person */
	FormGroups groups() {
		return FormGroups.NONE;
	}

	/** @return what goes along with its dialog, made anew; empty if nothing does */
	Optional<FormCompanion> companion() {
		return Optional.empty();
	}

	/** Writes a line to the log. */
	final void say(final String line) {
		if (log != null)
			log.info(line);
		else
			IJ.log(line);
	}

	private void refuse(final String sentence) {
		if (log != null)
			log.error(sentence);
		cancel(sentence);
	}

	/**
	 * Progress of a Command: in ImageJ's window if there is one (Esc cancels), else
	 * to SciJava's status; the Command's own cancel counts always.
	 */
	private static final class CommandProgress implements Progress, AutoCloseable {

		private static final int STEPS = 100;
		private static final double LAST = 0.999;

		private final StatusService status;
		private final BooleanSupplier cancelled;

		CommandProgress(final StatusService status, final BooleanSupplier cancelled) {
			this.status = status;
			this.cancelled = cancelled;
			// An Esc that was pressed before is not meant.
			IJ.resetEscape();
		}

		@Override
		public void report(final String stage, final double fraction) {
			if (IJ.getInstance() != null) {
				IJ.showStatus(stage + "...");
				// ImageJ takes the bar away at 1.
				IJ.showProgress(Math.min(LAST, fraction));
			} else if (status != null)
				status.showStatus((int) (STEPS * fraction), STEPS, stage);
		}

		@Override
		public boolean isCancelled() {
			return cancelled.getAsBoolean() || IJ.escapePressed();
		}

		@Override
		public void close() {
			if (IJ.getInstance() != null) {
				IJ.showStatus("");
				IJ.showProgress(1);
				IJ.resetEscape();
			} else if (status != null)
				status.clearStatus();
		}
	}
}
