package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.util.Locale;

import org.scijava.plugin.Plugin;

import ij.IJ;
import ij.Macro;
import ij.macro.Interpreter;
import ij.plugin.PlugIn;
import ij.plugin.frame.Recorder;
import io.github.knotresolver.imagej.form.FieldKind;
import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.FormDialog;
import io.github.knotresolver.imagej.form.FormField;
import io.github.knotresolver.imagej.form.MacroOptions;
import io.github.knotresolver.io.Failure;

/**
 * The menu's and the macros' way to every Command of this program, in plain
 * ImageJ, without a display and in Fiji alike: {@code plugins.config} names it
 * with the Command's class as its argument. A person gets a dialog made from the
 * Command's parameters, a macro's options go straight into them, and the
 * recorder writes a line that does the same again.
 */
public final class CommandPlugIn implements PlugIn {

	private static final String DOCS = "https://github.com/knotresolver/knotresolver-fiji/blob/main/docs/fiji.md";

	/**
	 * @param arg simple name of the Command's class
	 */
	@Override
	public void run(final String arg) {
		final KnotCommand command = create(arg);
		final String title = command.getClass().getAnnotation(Plugin.class).label();
		final String options = Macro.getOptions();
		if (options == null ? askPerson(command, title) : fill(command, title, options))
			execute(command, title, options == null && isInteractive());
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

	/** Without a person to ask, all values keep their defaults. */
	private static boolean askPerson(final KnotCommand command, final String title) {
		final Form form = Form.of(command);
		if (form.fields().isEmpty() || !isInteractive())
			return true;
		final String anchor = title.toLowerCase(Locale.ROOT).replaceAll("[^a-z ]", "").replace(' ',
			'-');
		if (!new FormDialog(form, title, DOCS + "#" + anchor).ask() || !hasAll(command, title)) {
			Recorder.setCommand(null);
			Macro.abort();
			return false;
		}
		if (Recorder.record)
			record(form);
		return true;
	}

	private static boolean hasAll(final KnotCommand command, final String title) {
		try {
			return command.askForMissing();
		} catch (final RuntimeException e) {
			stop(title, Failure.of(e, KnotCommand.MORE_MEMORY).sentence(), true);
			return false;
		}
	}

	private static void record(final Form form) {
		for (final FormField field : form.fields()) {
			final String text = field.text();
			if (text.isBlank())
				continue;
			final boolean path = field.kind() == FieldKind.FILE
				|| field.kind() == FieldKind.FOLDER;
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

	private static void execute(final KnotCommand command, final String title,
		final boolean interactive) {
		command.run();
		if (command.isCanceled())
			stop(title, command.getCancelReason(), interactive);
	}

	/** A person sees the sentence, a macro ends with it in the log. */
	private static void stop(final String title, final String sentence, final boolean interactive) {
		final Interpreter macro = Interpreter.getInstance();
		if (interactive && macro == null) {
			Recorder.setCommand(null);
			IJ.showMessage(title, sentence);
			return;
		}
		IJ.log(title + " " + sentence);
		if (macro != null) {
			// Without this, ImageJ would show the sentence in a dialog.
			macro.setIgnoreErrors(true);
			macro.abort(sentence);
		}
		Macro.abort();
	}
}
