package io.github.knotresolver.imagej.form;

import java.awt.Color;
import java.awt.Component;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.TextField;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.HashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.regex.Pattern;

import ij.gui.GenericDialog;
import ij.gui.MultiLineLabel;

/** ImageJ's dialog, which closes only if what was typed is accepted. */
final class FormWindow extends GenericDialog {

	private static final Color MARKED = new Color(255, 205, 205), SENTENCE = new Color(170, 0, 0);
	/** As many words as fit beside a field, or one that is longer. */
	private static final Pattern LINE = Pattern.compile("(\\S{41,}|.{1,40})(?:\\s+|$)");
	private static final int RIGHT = 9;

	private final transient BooleanSupplier accept;
	private final transient Map<Component, Color> marked = new HashMap<>();
	private final transient Map<Integer, Component> sentences = new HashMap<>();
	private boolean accepted;

	/**
	 * @param title title of the dialog
	 * @param accept asked when the user says OK; false keeps the dialog open
	 */
	FormWindow(final String title, final BooleanSupplier accept) {
		super(title);
		this.accept = accept;
	}

	/** @return whether the user said OK, and it was accepted */
	boolean isAccepted() {
		return accepted;
	}

	@Override
	public void actionPerformed(final ActionEvent event) {
		if (event.getSource() != getButtons()[0] || isAcceptedNow())
			super.actionPerformed(event);
	}

	@Override
	public void keyPressed(final KeyEvent event) {
		if (event.getKeyCode() != KeyEvent.VK_ENTER || isAcceptedNow())
			super.keyPressed(event);
	}

	private boolean isAcceptedNow() {
		accepted = accept.getAsBoolean();
		return accepted;
	}

	/** Takes all marks and sentences away. */
	void clear() {
		marked.forEach(Component::setBackground);
		marked.clear();
		sentences.values().forEach(this::remove);
		sentences.clear();
		if (isShowing())
			pack();
	}

	/** Marks a component, with a sentence beside it. */
	void mark(final Component component, final String sentence) {
		if (marked.isEmpty())
			component.requestFocus();
		marked.putIfAbsent(component,
			component.isBackgroundSet() ? component.getBackground() : null);
		component.setBackground(MARKED);
		if (component instanceof TextField field)
			field.selectAll();
		Component inRow = component;
		while (inRow.getParent() != null && inRow.getParent() != this)
			inRow = inRow.getParent();
		add(sentence, ((GridBagLayout) getLayout()).getConstraints(inRow).gridy);
	}

	/** Shows a sentence that belongs to no component, at the top. */
	void say(final String sentence) {
		add(sentence, 0);
	}

	private void add(final String sentence, final int row) {
		final Component earlier = sentences.get(row);
		if (earlier != null)
			remove(earlier);
		final MultiLineLabel label = new MultiLineLabel(
			LINE.matcher(sentence).replaceAll("$1\n").strip());
		label.setForeground(SENTENCE);
		final GridBagConstraints place = new GridBagConstraints();
		place.gridx = RIGHT;
		place.gridy = row;
		place.anchor = GridBagConstraints.WEST;
		place.insets = new Insets(0, 10, 0, 5);
		add(label, place);
		sentences.put(row, label);
		if (isShowing())
			pack();
	}
}
