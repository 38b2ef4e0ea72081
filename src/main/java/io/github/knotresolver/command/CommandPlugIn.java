package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

import org.scijava.plugin.Plugin;

import ij.IJ;
import ij.Macro;
import ij.macro.Interpreter;
import ij.plugin.PlugIn;
import ij.plugin.frame.Recorder;
import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.FormField;
import io.github.knotresolver.imagej.form.MacroOptions;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.ui.FormDialog;

/**
 * The menu's and the macros' way to every Command of this program, in plain
 * ImageJ, without a display and in Fiji alike: {@code plugins.config} names it
 * with the Command's class as its argument. A person gets a dialog made from the
 * Command's parameters, a macro's options go straight into them, and the
 * recorder writes a line that does the same again.
 */
public final class CommandPlugIn implements PlugIn {

	/** The user does not go on. */
	private static final Failure GIVEN_UP = new Failure(Failure.Kind.CANCELLED, "");

	private static final String DOCS = "https://github.com/knotresolver/knotresolver-fiji/blob/main/docs/fiji.md";

	/**
	 * @param arg simple name of the Command's class
	 */
	@Override
	public void run(final String arg) {
		final KnotCommand command = create(arg);
		final String title = command.getClass().getAnnotation(Plugin.class).label();
		final String options = Macro.getOptions();
		if (options != null) {
			if (fill(command, title, options))
				execute(command, title);
		} else if (isInteractive() && !Form.of(command).fields().isEmpty())
			converse(command, arg, title);
		else
			// Without a person to ask, all values keep their defaults.
			execute(command, title);
	}

	/**
	 * Opens a Command's dialog with some values filled in; returns at once.
	 *
	 * @param name of the Command's class
	 * @param texts values by key
	 */
	static void open(final String name, final Map<String, String> texts) {
		final KnotCommand command = create(name);
		Form.of(command).fill(texts);
		final String title = command.getClass().getAnnotation(Plugin.class).label();
		new Thread(() -> converse(command, name, title), title).start();
	}

	/** Until the Command is done or given up: what it refuses, the dialog shows again. */
	private static void converse(final KnotCommand first, final String arg, final String title) {
		KnotCommand command = first;
		Optional<String> problem = Optional.empty();
		while (ask(command, title, problem)) {
			final Optional<Failure> failure = attempt(command, title);
			if (failure.isEmpty())
				return;
			problem = failure.filter(CommandPlugIn::canBeMended).map(Failure::sentence);
			if (problem.isEmpty()) {
				stop(title, failure.get().sentence(), true);
				return;
			}
			final KnotCommand next = create(arg);
			Form.of(next).fill(Form.of(command).texts());
			command = next;
		}
		giveUp();
	}

	private static boolean ask(final KnotCommand command, final String title,
		final Optional<String> problem) {
		final String anchor = title.toLowerCase(Locale.ROOT).replaceAll("[^a-z ]", "").replace(' ',
			'-');
		return FormDialog.ask(new FormDialog.Texts(title, DOCS + "#" + anchor, problem),
			Form.of(command), command.groups(), command.companion(), command::check);
	}

	/** Why there is no result; empty if there is one. */
	private static Optional<Failure> attempt(final KnotCommand command, final String title) {
		try {
			if (!command.askForMissing())
				return Optional.of(GIVEN_UP);
		} catch (final RuntimeException e) {
			return Optional.of(Failure.of(e, KnotCommand.MORE_MEMORY));
		}
		if (Recorder.record)
			record(Form.of(command), title);
		command.watch();
		command.run();
		return command.failure();
	}

	private static boolean canBeMended(final Failure failure) {
		return failure.kind() == Failure.Kind.USER || failure.kind() == Failure.Kind.DISK;
	}

	private static KnotCommand create(final String name) {
		try {
			return (KnotCommand) Class.forName(KnotCommand.class.getPackageName() + "." + name)
				.getDeclaredConstructor().newInstance();
		} catch (final ReflectiveOperationException e) {
			throw new IllegalArgumentException("There is no Command " + name + ".", e);
		}
	}

	private static boolean isInteractive() {
		return !GraphicsEnvironment.isHeadless() && !Interpreter.isBatchMode();
	}

	private static void record(final Form form, final String title) {
		Recorder.setCommand(title);
		for (final FormField field : form.fields()) {
			final String text = field.text();
			if (text.isBlank())
				continue;
			final boolean path = field.kind() == FormField.Kind.FILE
				|| field.kind() == FormField.Kind.FOLDER;
			// Of a key without a value, and of a path's key, the recorder looks for the bare word,
			// which may be a part of any value.
			Recorder.recordOption(field.key(), path ? Recorder.fixPath(text) : text);
		}
	}

	private static boolean fill(final KnotCommand command, final String title,
		final String options) {
		try {
			Form.of(command).fill(MacroOptions.parse(options, CommandPlugIn::variable));
			return true;
		} catch (final RuntimeException e) {
			stop(title, Failure.of(e, KnotCommand.MORE_MEMORY).sentence(), false);
			return false;
		}
	}

	private static String variable(final String name) {
		final Interpreter macro = Interpreter.getInstance();
		return macro == null ? null : macro.getVariableAsString(name);
	}

	private static void execute(final KnotCommand command, final String title) {
		command.run();
		command.failure().ifPresent(f -> stop(title, f.sentence(),
			isInteractive() && Macro.getOptions() == null && Interpreter.getInstance() == null));
	}

	/** A person sees the sentence, a macro ends with it in the log. */
	private static void stop(final String title, final String sentence, final boolean interactive) {
		if (interactive) {
			if (!sentence.isEmpty())
				IJ.showMessage(title, sentence);
			giveUp();
			return;
		}
		IJ.log(title + " " + sentence);
		final Interpreter macro = Interpreter.getInstance();
		if (macro != null) {
			// Without this, ImageJ would show the sentence in a dialog.
			macro.setIgnoreErrors(true);
			macro.abort(sentence);
		}
		Macro.abort();
	}

	/** Nothing is recorded, and a macro that opened the dialog ends. */
	private static void giveUp() {
		Recorder.setCommand(null);
		Macro.abort();
	}
}
