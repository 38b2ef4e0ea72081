package io.github.knotresolver.ui;

import java.awt.event.ActionEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;

import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import javax.swing.WindowConstants;

/** What keys and the closing of a window do. */
final class WindowActions {

	private WindowActions() {
	}

	/**
	 * Binds a key in a whole window.
	 *
	 * @param root of the window
	 * @param key as {@link KeyStroke#getKeyStroke(String)} reads it, such as {@code ctrl Z}
	 * @param action what it does
	 */
	static void onKey(final JRootPane root, final String key, final Runnable action) {
		root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key), key);
		root.getActionMap().put(key, new AbstractAction() {

			private static final long serialVersionUID = 1L;

			@Override
			public void actionPerformed(final ActionEvent e) {
				action.run();
			}
		});
	}

	/**
	 * @param window stays open when its user closes it
	 * @param action what happens in place of that
	 */
	static void onClosing(final JFrame window, final Runnable action) {
		window.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
		window.addWindowListener(new WindowAdapter() {

			@Override
			public void windowClosing(final WindowEvent e) {
				action.run();
			}
		});
	}
}
