package io.github.knotresolver.imagej.form;

import java.awt.Checkbox;
import java.awt.Choice;
import java.awt.Component;
import java.awt.TextField;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.GenericDialog;
import io.github.knotresolver.model.UserException;

/**
 * A form as an ImageJ dialog. It stays open until its values are allowed or the user gives up: a
 * wrong one is marked, with the sentence beside it. Values are read from the dialog's components and
 * not by {@code getNext...()}, which would record keys of its own and would not record a box that
 * was unchecked.
 */
public final class FormDialog {

	private static final int WIDE = 25, NARROW = 8;

	private final Form form;
	private final Runnable check;
	private final FormWindow window;
	private final Map<FormField, Component> components = new LinkedHashMap<>();

	/**
	 * @param form the form
	 * @param title title of the dialog
	 * @param help address behind the Help button
	 * @param check what is to hold of the form as a whole; throws a {@link UserException} if it
	 *          does not
	 */
	public FormDialog(final Form form, final String title, final String help,
		final Runnable check) {
		this.form = form;
		this.check = check;
		window = new FormWindow(title, this::accept);
		build();
		window.addHelp(help);
	}

	/**
	 * Shows the dialog.
	 *
	 * @param problem what was wrong with the values at first; empty if nothing was
	 * @return whether the form was filled in
	 */
	public boolean ask(final Optional<String> problem) {
		problem.ifPresent(this::show);
		window.showDialog();
		return window.isAccepted();
	}

	/** Fills in the form; false if something is wrong, which is shown then. */
	private boolean accept() {
		window.clear();
		boolean allowed = true;
		for (final Map.Entry<FormField, Component> entry : components.entrySet())
			try {
				entry.getKey().set(text(entry.getValue()));
			} catch (final UserException e) {
				window.mark(entry.getValue(), e.getMessage());
				allowed = false;
			}
		if (!allowed)
			return false;
		try {
			check.run();
			return true;
		} catch (final UserException e) {
			show(e.getMessage());
			return false;
		}
	}

	private void show(final String problem) {
		final Optional<Component> meant = form.mentioned(problem).map(components::get);
		meant.ifPresentOrElse(c -> window.mark(c, problem), () -> window.say(problem));
	}

	private void build() {
		FormField before = null;
		for (final FormField field : form.fields()) {
			if (field.kind() == FieldKind.IMAGE && WindowManager.getImageCount() < 2)
				continue;
			if (before != null && isNarrow(before) && isNarrow(field))
				window.addToSameRow();
			before = before != null && isNarrow(before) && isNarrow(field) ? null : field;
			components.put(field, add(window, field));
		}
	}

	/** Two of these share a row. */
	private static boolean isNarrow(final FormField field) {
		return switch (field.kind()) {
			case FILE, FOLDER, IMAGE -> false;
			default -> true;
		};
	}

	private static Component add(final GenericDialog dialog, final FormField field) {
		final String text = field.text();
		final Function<List<?>, Component> last = all -> (Component) all.get(all.size() - 1);
		switch (field.kind()) {
			case FLAG :
				dialog.addCheckbox(field.label(), Boolean.parseBoolean(text));
				return last.apply(dialog.getCheckboxes());
			case CHOICE :
				dialog.addChoice(field.label(), field.choices().toArray(String[]::new), text);
				return last.apply(dialog.getChoices());
			case IMAGE :
				addImage(dialog, field.label(), text);
				return last.apply(dialog.getChoices());
			case FILE :
				dialog.addFileField(field.label(), text, WIDE);
				break;
			case FOLDER :
				dialog.addDirectoryField(field.label(), text, WIDE);
				break;
			default :
				dialog.addStringField(field.label(), text, NARROW);
		}
		return last.apply(dialog.getStringFields());
	}

	private static void addImage(final GenericDialog dialog, final String label,
		final String chosen) {
		final List<String> titles = new ArrayList<>(List.of(WindowManager.getImageTitles()));
		final ImagePlus active = WindowManager.getCurrentImage();
		final String first = chosen.isEmpty() && active != null ? active.getTitle() : chosen;
		dialog.addChoice(label, titles.toArray(String[]::new), first);
	}

	private static String text(final Component component) {
		if (component instanceof Checkbox box)
			return Boolean.toString(box.getState());
		return component instanceof Choice choice
			? choice.getSelectedItem()
			: ((TextField) component).getText();
	}
}
