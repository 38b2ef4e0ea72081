package io.github.knotresolver.ui;

import java.awt.Window;
import java.util.Map;
import java.util.Optional;

import javax.swing.JComponent;

/** What goes along with a dialog while it is open. Called by the thread of events. */
public interface FormCompanion extends AutoCloseable {

	/**
	 * @param resized to be called when the panel needs more or less room
	 * @return what it shows in the dialog; called once
	 */
	JComponent panel(Runnable resized);

	/**
	 * Called at first and after every change of a value.
	 *
	 * @param texts what is in the dialog now, allowed or not, by the options' names
	 */
	void changed(Map<String, String> texts);

	/** @return the window that the dialog should not cover; empty if there is none */
	Optional<Window> beside();

	/** The dialog is closed. */
	@Override
	void close();
}
