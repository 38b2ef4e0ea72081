package io.github.knotresolver.ui;

import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;

import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;

import ij.ImagePlus;
import ij.gui.TextRoi;

/**
 * The keys of a review work in the image's window, too, where the mouse was last; all other keys are
 * ImageJ's, and all of them while a text is typed on the image.
 */
final class ImageKeys implements KeyEventDispatcher, AutoCloseable {

	private final ImagePlus image;
	private final JRootPane root;

	/**
	 * @param image under review
	 * @param root has the keys and what they do
	 */
	ImageKeys(final ImagePlus image, final JRootPane root) {
		this.image = image;
		this.root = root;
		KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
	}

	@Override
	public boolean dispatchKeyEvent(final KeyEvent e) {
		final KeyboardFocusManager focus = KeyboardFocusManager.getCurrentKeyboardFocusManager();
		if (e.getID() != KeyEvent.KEY_PRESSED || image.getWindow() == null
			|| focus.getFocusedWindow() != image.getWindow() || image.getRoi() instanceof TextRoi)
			return false;
		final Object name = root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
			.get(KeyStroke.getKeyStrokeForEvent(e));
		final Action action = name == null ? null : root.getActionMap().get(name);
		if (action == null)
			return false;
		action
			.actionPerformed(new ActionEvent(root, ActionEvent.ACTION_PERFORMED, name.toString()));
		return true;
	}

	@Override
	public void close() {
		KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
	}
}
