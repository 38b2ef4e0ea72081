package io.github.knotresolver.ui;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Font;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Collectors;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;

import ij.ImageListener;
import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.GUI;
import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.FormField;
import io.github.knotresolver.imagej.form.FormGroups;
import io.github.knotresolver.model.UserException;

/** The fields of a form: some at once, the others in groups that are closed at first. */
final class FormFields implements ImageListener, AutoCloseable {

	private static final int GAP = 4, COLUMNS = 4;
	private static final Color LINE = new Color(0x99, 0x99, 0x99);

	/** The open groups take no more than this part of the screen's height. */
	private static final double SHARE = 0.6;

	private final Map<String, FieldEditor> editors = new LinkedHashMap<>();
	private final Map<FormField, String> defaults = new LinkedHashMap<>();
	private final Runnable changed, resized;
	private final FormGroups groups;
	private final JPanel panel = new JPanel(new BorderLayout(GAP, GAP));
	private final JButton toggle = new JButton();
	private final JLabel told = new JLabel();
	private JComponent advanced;

	/**
	 * @param changed told when a person has changed a value
	 * @param resized told when the panel needs more or less room
	 */
	FormFields(final Form form, final FormGroups groups, final Runnable changed,
		final Runnable resized) {
		this.changed = changed;
		this.resized = resized;
		this.groups = groups;
		for (final FormField field : form.fields())
			if (field.kind() != FormField.Kind.IMAGE || WindowManager.getImageCount() > 0) {
				editors.put(field.name(), new FieldEditor(field, this::changed));
				defaults.put(field, field.byDefault());
			}
		final List<String> basic = groups.basic().isEmpty()
			? List.copyOf(editors.keySet())
			: groups.basic();
		panel.add(new Grid().fields(basic).panel, BorderLayout.NORTH);
		if (!groups.advanced().isEmpty())
			build();
		ImagePlus.addImageListener(this);
	}

	private void build() {
		toggle.setName("Advanced");
		toggle.setMnemonic('A');
		toggle.setBorderPainted(false);
		toggle.setContentAreaFilled(false);
		toggle.setMargin(new Insets(0, 0, 0, 0));
		toggle.setToolTipText("Everything else, in the order in which data flows (Alt-A)");
		toggle.addActionListener(e -> open(!isOpen()));
		final Grid grid = new Grid();
		for (final FormGroups.Group group : groups.advanced())
			grid.heading(group.heading()).fields(group.names());
		final JScrollPane scroll = new JScrollPane(grid.panel);
		scroll.setBorder(BorderFactory.createEmptyBorder());
		scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
		scroll.getVerticalScrollBar().setUnitIncrement(16);
		advanced = scroll;
		final JPanel row = new JPanel(new FlowLayout(FlowLayout.LEFT, 0, 0));
		row.add(toggle);
		row.add(told);
		final JPanel below = new JPanel(new BorderLayout(GAP, GAP));
		below.add(row, BorderLayout.NORTH);
		below.add(scroll, BorderLayout.CENTER);
		panel.add(below, BorderLayout.CENTER);
		advanced.setVisible(false);
		tell();
	}

	JComponent panel() {
		return panel;
	}

	private boolean isOpen() {
		return advanced != null && advanced.isVisible();
	}

	private void open(final boolean wanted) {
		advanced.setPreferredSize(null);
		final Dimension size = advanced.getPreferredSize();
		final int most = (int) (SHARE * GUI.getMaxWindowBounds(panel).height);
		// With room for the bar, also if a person makes the window lower later.
		final int bar = ((JScrollPane) advanced).getVerticalScrollBar().getPreferredSize().width;
		advanced.setPreferredSize(new Dimension(size.width + bar, Math.min(size.height, most)));
		advanced.setVisible(wanted);
		tell();
		resized.run();
	}

	/** What was changed among the fields that are not seen. */
	private void tell() {
		toggle.setText((isOpen() ? "\u25be" : "\u25b8") + " Advanced");
		final String hidden = groups.advanced().stream().flatMap(g -> g.names().stream())
			.map(editors::get)
			.filter(e -> e != null && !e.text().strip().equals(defaults.get(e.field())))
			.map(e -> e.field().key() + "=" + e.text().strip()).collect(Collectors.joining(", "));
		told.setText(hidden.isEmpty() || isOpen() ? "" : "   " + hidden);
	}

	private void changed() {
		if (advanced != null)
			tell();
		changed.run();
	}

	/** @return what is in the fields, by the options' names */
	Map<String, String> texts() {
		final Map<String, String> texts = new LinkedHashMap<>();
		editors.forEach((name, editor) -> texts.put(name, editor.text()));
		return texts;
	}

	/**
	 * Takes the values into the form.
	 *
	 * @param problems told what is wrong with a value
	 * @return whether all are allowed
	 */
	boolean fill(final Consumer<String> problems) {
		boolean allowed = true;
		editors.values().forEach(FieldEditor::unmark);
		for (final FieldEditor editor : editors.values())
			try {
				// Of a single image a macro need not know the title.
				if (editor.field().kind() != FormField.Kind.IMAGE
					|| WindowManager.getImageCount() > 1)
					editor.field().set(editor.text());
			} catch (final UserException e) {
				mark(editor.field());
				problems.accept(e.getMessage());
				allowed = false;
			}
		return allowed;
	}

	/** Shows that a field's value is not allowed. */
	void mark(final FormField field) {
		final FieldEditor editor = editors.get(field.name());
		if (editor == null)
			return;
		if (groups.advanced().stream().anyMatch(g -> g.names().contains(field.name())) && !isOpen())
			open(true);
		editor.mark();
	}

	@Override
	public void imageOpened(final ImagePlus image) {
		refreshImages();
	}

	@Override
	public void imageClosed(final ImagePlus image) {
		refreshImages();
	}

	@Override
	public void imageUpdated(final ImagePlus image) {
		// Its title stays.
	}

	private void refreshImages() {
		// ImageJ's list follows its own events.
		SwingUtilities.invokeLater(() -> editors.values().forEach(FieldEditor::refreshImages));
	}

	@Override
	public void close() {
		ImagePlus.removeImageListener(this);
	}

	/** Fields in rows: words and value, twice where both are short. */
	private final class Grid {

		private final JPanel panel = new JPanel(new GridBagLayout());
		private int row;

		Grid heading(final String words) {
			final JLabel label = new JLabel(words);
			label.setFont(label.getFont().deriveFont(Font.BOLD));
			// In some looks all words are bold: the line tells headings from fields.
			label.setBorder(BorderFactory.createCompoundBorder(
				BorderFactory.createEmptyBorder(2 * GAP, 0, GAP / 2, 0),
				BorderFactory.createMatteBorder(0, 0, 1, 0, LINE)));
			place(label, 0, COLUMNS, GridBagConstraints.HORIZONTAL);
			row++;
			return this;
		}

		Grid fields(final List<String> names) {
			final List<FieldEditor> waiting = new ArrayList<>();
			for (final String name : names) {
				final FieldEditor editor = editors.get(name);
				if (editor == null)
					continue;
				if (!waiting.isEmpty() && !editor.isNarrow())
					end(waiting);
				add(editor, 2 * waiting.size());
				waiting.add(editor);
				if (!editor.isNarrow() || waiting.size() == 2)
					end(waiting);
			}
			if (!waiting.isEmpty())
				end(waiting);
			return this;
		}

		private void end(final List<FieldEditor> waiting) {
			waiting.clear();
			row++;
		}

		private void add(final FieldEditor editor, final int column) {
			final boolean flag = editor.field().kind() == FormField.Kind.FLAG;
			final int width = editor.isNarrow() ? 1 : COLUMNS - 1;
			if (!flag)
				place(editor.label(), column, 1, GridBagConstraints.NONE);
			place(editor.component(), flag ? column : column + 1, flag ? 2 : width,
				GridBagConstraints.HORIZONTAL);
		}

		private void place(final Component part, final int column, final int width,
			final int fill) {
			final GridBagConstraints place = new GridBagConstraints();
			place.gridx = column;
			place.gridy = row;
			place.gridwidth = width;
			place.fill = fill;
			place.anchor = GridBagConstraints.LINE_START;
			place.weightx = fill == GridBagConstraints.NONE ? 0 : 1;
			place.insets = new Insets(GAP / 2,
				column > 0 && fill == GridBagConstraints.NONE ? 12 : 2, GAP / 2,
				fill == GridBagConstraints.NONE ? GAP : 2);
			panel.add(part, place);
		}
	}
}
