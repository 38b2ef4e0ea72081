package io.github.knotresolver.ui;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.io.File;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import javax.swing.BorderFactory;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.border.Border;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

import ij.ImagePlus;
import ij.WindowManager;
import ij.io.OpenDialog;
import io.github.knotresolver.imagej.form.FormField;

/** One field of a form on the screen, with its words and its help. */
final class FieldEditor {

	private static final int WIDE = 26, NARROW = 8;
	private static final Color MARKED = new Color(255, 205, 205),
		EDGE = new Color(0xa0, 0x00, 0x00);

	private final FormField field;
	private final Runnable changed;
	private final JComponent input;
	private final JComponent whole;
	private final JLabel label;
	private Optional<Look> before = Optional.empty();

	private record Look(Color ground, Border border) {
	}

	/** @param changed told when a person has changed the value */
	FieldEditor(final FormField field, final Runnable changed) {
		this.field = field;
		this.changed = changed;
		input = input();
		whole = isFile() ? withButton() : input;
		label = new JLabel(field.kind() == FormField.Kind.FLAG ? "" : field.label());
		label.setLabelFor(input);
		input.setName(field.name());
		input.addFocusListener(new FocusAdapter() {

			@Override
			public void focusGained(final FocusEvent e) {
				input.scrollRectToVisible(new Rectangle(input.getSize()));
			}
		});
		for (final JComponent part : List.of(input, label))
			part.setToolTipText(help());
	}

	private boolean isFile() {
		return field.kind() == FormField.Kind.FILE || field.kind() == FormField.Kind.FOLDER;
	}

	/** @return whether two of these share a row */
	boolean isNarrow() {
		return !isFile() && !field.isLong() && field.kind() != FormField.Kind.IMAGE;
	}

	/** @return what it is, what is allowed, and its key */
	private String help() {
		final String what = field.description().isEmpty() ? field.label() : field.description();
		return what + " (" + (field.kind() == FormField.Kind.TEXT ? "" : field.allowed() + "; ")
			+ "in macros: " + field.key() + ")";
	}

	private JComponent input() {
		switch (field.kind()) {
			case FLAG :
				final JCheckBox box = new JCheckBox(field.label(),
					Boolean.parseBoolean(field.text()));
				box.addActionListener(e -> changed.run());
				return box;
			case CHOICE :
				return choice(field.choices(), field.text());
			case IMAGE :
				final ImagePlus active = WindowManager.getCurrentImage();
				return choice(List.of(WindowManager.getImageTitles()),
					field.text().isEmpty() && active != null ? active.getTitle() : field.text());
			default :
				final JTextField text = new JTextField(field.text(), isNarrow() ? NARROW : WIDE);
				text.getDocument().addDocumentListener(new Typed());
				return text;
		}
	}

	private JComboBox<String> choice(final List<String> words, final String chosen) {
		final JComboBox<String> choice = new JComboBox<>(words.toArray(String[]::new));
		choice.setSelectedItem(chosen);
		choice.addActionListener(e -> changed.run());
		return choice;
	}

	private JPanel withButton() {
		final JButton browse = new JButton("Browse...");
		browse.setToolTipText("Choose it");
		browse.setName("browse " + field.name());
		browse.addActionListener(e -> browse());
		final JPanel both = new JPanel(new BorderLayout(4, 0));
		both.add(input, BorderLayout.CENTER);
		both.add(browse, BorderLayout.EAST);
		return both;
	}

	private void browse() {
		final String present = text();
		final JFileChooser chooser = new JFileChooser(
			present.isBlank() ? OpenDialog.getDefaultDirectory() : new File(present).getParent());
		chooser.setFileSelectionMode(field.kind() == FormField.Kind.FOLDER
			? JFileChooser.DIRECTORIES_ONLY
			: JFileChooser.FILES_AND_DIRECTORIES);
		if (chooser.showDialog(input, "Choose") == JFileChooser.APPROVE_OPTION)
			((JTextField) input).setText(chooser.getSelectedFile().getPath());
	}

	FormField field() {
		return field;
	}

	/** @return the words before it */
	JLabel label() {
		return label;
	}

	/** @return what a person uses */
	Component component() {
		return whole;
	}

	/** @return what is in it */
	String text() {
		if (input instanceof JCheckBox box)
			return Boolean.toString(box.isSelected());
		if (input instanceof JComboBox<?> choice)
			return choice.getSelectedItem() == null ? "" : choice.getSelectedItem().toString();
		return ((JTextField) input).getText();
	}

	/** Images come and go. */
	void refreshImages() {
		if (field.kind() != FormField.Kind.IMAGE)
			return;
		final JComboBox<String> choice = images();
		final List<String> titles = List.of(WindowManager.getImageTitles()),
			present = new ArrayList<>();
		for (int i = 0; i < choice.getItemCount(); i++)
			present.add(choice.getItemAt(i));
		if (titles.equals(present))
			return;
		final Object chosen = choice.getSelectedItem();
		choice.setModel(new DefaultComboBoxModel<>(titles.toArray(String[]::new)));
		if (titles.contains(chosen))
			choice.setSelectedItem(chosen);
		changed.run();
	}

	@SuppressWarnings("unchecked")
	private JComboBox<String> images() {
		return (JComboBox<String>) input;
	}

	/** Shows that the value is not allowed; not by colour alone. */
	void mark() {
		if (before.isPresent())
			return;
		before = Optional.of(new Look(input.getBackground(), input.getBorder()));
		input.setBackground(MARKED);
		input.setBorder(BorderFactory.createLineBorder(EDGE, 2));
		input.requestFocusInWindow();
		if (input instanceof JTextField text)
			text.selectAll();
	}

	void unmark() {
		before.ifPresent(look -> {
			input.setBackground(look.ground);
			input.setBorder(look.border);
		});
		before = Optional.empty();
	}

	/** Any change of a text. */
	private final class Typed implements DocumentListener {

		@Override
		public void insertUpdate(final DocumentEvent e) {
			changed.run();
		}

		@Override
		public void removeUpdate(final DocumentEvent e) {
			changed.run();
		}

		@Override
		public void changedUpdate(final DocumentEvent e) {
			changed.run();
		}
	}
}
