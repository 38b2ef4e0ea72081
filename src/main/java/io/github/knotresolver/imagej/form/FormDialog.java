package io.github.knotresolver.imagej.form;

import java.awt.Checkbox;
import java.awt.Choice;
import java.awt.TextField;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;

import ij.IJ;
import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.GenericDialog;

import io.github.knotresolver.model.UserException;

/**
 * A form as an ImageJ dialog. Values are read from the dialog's components and
 * not by {@code getNext...()}, which would record keys of its own and would not
 * record a box that was unchecked.
 */
public final class FormDialog {

	private static final int WIDE = 25, NARROW = 8;

	private final Form form;
	private final String title;
	private final String help;

	/**
	 * @param form the form
	 * @param title title of the dialog
	 * @param help address behind the Help button
	 */
	public FormDialog(final Form form, final String title, final String help) {
		this.form = form;
		this.title = title;
		this.help = help;
	}

	/**
	 * Shows the dialog until its values are allowed or the user gives up.
	 *
	 * @return whether the form was filled in
	 */
	public boolean ask() {
		Map<String, String> texts = form.texts();
		while (true) {
			final GenericDialog dialog = new GenericDialog(title);
			final Map<String, Supplier<String>> values = build(dialog, texts);
			dialog.addHelp(help);
			dialog.showDialog();
			if (dialog.wasCanceled())
				return false;
			final Map<String, String> typed = new LinkedHashMap<>();
			values.forEach((key, value) -> typed.put(key, value.get()));
			try {
				form.fill(typed);
				return true;
			} catch (final UserException e) {
				IJ.showMessage(title, e.getMessage());
				texts = typed;
			}
		}
	}

	private Map<String, Supplier<String>> build(final GenericDialog dialog,
		final Map<String, String> texts) {
		final Map<String, Supplier<String>> values = new LinkedHashMap<>();
		FormField before = null;
		for (final FormField field : form.fields()) {
			if (field.kind() == FieldKind.IMAGE && WindowManager.getImageCount() < 2)
				continue;
			if (before != null && isNarrow(before) && isNarrow(field))
				dialog.addToSameRow();
			before = before != null && isNarrow(before) && isNarrow(field) ? null : field;
			values.put(field.key(), add(dialog, field, texts.getOrDefault(field.key(), "")));
		}
		return values;
	}

	/** Two of these share a row. */
	private static boolean isNarrow(final FormField field) {
		return switch (field.kind()) {
			case FILE, FOLDER, IMAGE -> false;
			default -> true;
		};
	}

	private static Supplier<String> add(final GenericDialog dialog, final FormField field,
		final String text) {
		switch (field.kind()) {
			case FLAG :
				dialog.addCheckbox(field.label(), Boolean.parseBoolean(text));
				final Checkbox box = (Checkbox) dialog.getCheckboxes().lastElement();
				return () -> Boolean.toString(box.getState());
			case CHOICE :
				return choice(dialog, field.label(), field.choices(), text);
			case IMAGE :
				return image(dialog, field.label());
			case FILE :
				dialog.addFileField(field.label(), text, WIDE);
				break;
			case FOLDER :
				dialog.addDirectoryField(field.label(), text, WIDE);
				break;
			default :
				dialog.addStringField(field.label(), text, NARROW);
		}
		final TextField typed = (TextField) dialog.getStringFields().lastElement();
		return typed::getText;
	}

	private static Supplier<String> image(final GenericDialog dialog, final String label) {
		final List<String> titles = new ArrayList<>(List.of(WindowManager.getImageTitles()));
		final ImagePlus active = WindowManager.getCurrentImage();
		return choice(dialog, label, titles, active == null ? "" : active.getTitle());
	}

	private static Supplier<String> choice(final GenericDialog dialog, final String label,
		final List<String> choices, final String chosen) {
		dialog.addChoice(label, choices.toArray(String[]::new), chosen);
		final Choice choice = (Choice) dialog.getChoices().lastElement();
		return choice::getSelectedItem;
	}
}
