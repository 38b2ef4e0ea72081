package io.github.knotresolver.command;

import java.awt.Button;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.Label;
import java.awt.TextField;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JSpinner;
import javax.swing.JTextArea;
import javax.swing.JTextField;

import ij.IJ;
import ij.gui.MultiLineLabel;

/** ImageJ's windows as a person works with them: finds, reads and presses. */
final class Windows {

	private static final long PATIENCE_MILLIS = 180_000;

	private Windows() {
	}

	/** As the menu does it: in a thread of its own, without options. */
	static void start(final String command) {
		IJ.doCommand(command);
	}

	/** Waits for a dialog with this title and words. */
	static Dialog dialog(final String title, final String... words) throws Exception {
		final List<Dialog> found = new ArrayList<>();
		await("dialog " + title + " " + List.of(words), () -> {
			found.clear();
			dialogs().filter(d -> title.equals(d.getTitle()))
				.filter(d -> Arrays.stream(words).allMatch(text(d)::contains))
				.filter(Windows::isWaitedFor).forEach(found::add);
			return !found.isEmpty();
		});
		return found.get(0);
	}

	/** Waits for a message, and closes it and all other dialogs. */
	static String message(final String sentence) throws Exception {
		final List<Dialog> found = new ArrayList<>();
		await("message '" + sentence + "'", () -> {
			dialogs().filter(d -> text(d).contains(sentence)).filter(Windows::isWaitedFor)
				.forEach(found::add);
			return !found.isEmpty();
		});
		final String text = text(found.get(0)).strip();
		dispose(found.get(0));
		// The Command ends, and is recorded, after its message is gone.
		Thread.sleep(300);
		closeDialogs();
		Thread.sleep(300);
		return text;
	}

	static void closeDialogs() {
		dialogs().toList().forEach(d -> press(d, "Cancel"));
		dialogs().toList().forEach(Windows::dispose);
	}

	/** By the thread of events: from another one, what is disposed twice is waited for without end. */
	private static void dispose(final Dialog dialog) {
		try {
			EventQueue.invokeAndWait(dialog::dispose);
		} catch (final InterruptedException | InvocationTargetException e) {
			throw new IllegalStateException(e);
		}
	}

	/**
	 * A modal dialog is seen before the thread that shows it waits for its end; if it is disposed in
	 * between, that thread waits without end.
	 */
	private static boolean isWaitedFor(final Dialog dialog) {
		return !dialog.isModal() || Thread.getAllStackTraces().values().stream()
			.anyMatch(s -> Arrays.stream(s).skip(1)
				.anyMatch(f -> f.getClassName().equals("java.awt.WaitDispatchSupport")
					&& f.getMethodName().equals("enter")));
	}

	static Stream<Dialog> dialogs() {
		return Arrays.stream(Window.getWindows()).filter(Dialog.class::isInstance)
			.filter(Window::isShowing).map(Dialog.class::cast);
	}

	/** All words in a window. */
	static String text(final Container container) {
		final StringBuilder text = new StringBuilder();
		for (final Component c : container.getComponents())
			if (c instanceof Label label)
				text.append(label.getText()).append(' ');
			else if (c instanceof JLabel label)
				text.append(label.getText()).append(' ');
			else if (c instanceof JTextArea area)
				text.append(area.getText().replace('\n', ' ')).append(' ');
			else if (c instanceof MultiLineLabel label)
				text.append(lines(label)).append(' ');
			else if (c instanceof Container inner)
				text.append(text(inner));
		return text.toString();
	}

	private static String lines(final MultiLineLabel label) {
		try {
			final var lines = label.getClass().getDeclaredField("lines");
			lines.setAccessible(true);
			return String.join(" ", (String[]) lines.get(label));
		} catch (final ReflectiveOperationException e) {
			throw new IllegalStateException(e);
		}
	}

	/** Waits for a window with this title. */
	static Frame frame(final String title) throws Exception {
		return frame(title, title::equals);
	}

	/** Waits for a window whose title is such a one. */
	static Frame frame(final String what, final Predicate<String> title) throws Exception {
		await(what, () -> shown(title).isPresent());
		return shown(title).orElseThrow();
	}

	/** The window whose title is such a one, if there is one. */
	static Optional<Frame> shown(final Predicate<String> title) {
		return Arrays.stream(Frame.getFrames())
			.filter(f -> f.isShowing() && title.test(f.getTitle())).findFirst();
	}

	/** The part of a window that has this name. */
	static Component find(final Container container, final String name) {
		return named(container, name).orElseThrow(() -> new AssertionError("no " + name));
	}

	/** The part of a window that has this name, if there is one. */
	static Optional<Component> named(final Container container, final String name) {
		for (final Component c : container.getComponents()) {
			if (name.equals(c.getName()) && c instanceof JComponent)
				return Optional.of(c);
			if (c instanceof Container inner && named(inner, name).isPresent())
				return named(inner, name);
		}
		return Optional.empty();
	}

	/** All components of a kind, in their order. */
	static <T extends Component> List<T> all(final Container container, final Class<T> kind) {
		final List<T> found = new ArrayList<>();
		for (final Component c : container.getComponents())
			if (kind.isInstance(c))
				found.add(kind.cast(c));
			else if (c instanceof Container inner)
				found.addAll(all(inner, kind));
		return found;
	}

	/** The field that the words are for. */
	static JTextField field(final Container dialog, final String label) {
		return fieldOf(dialog, label, JTextField.class);
	}

	/** Types into the field that the words are for, or that follows them. */
	static void type(final Container dialog, final String label, final String text)
		throws Exception {
		if (all(dialog, TextField.class).isEmpty())
			onEvents(() -> field(dialog, label).setText(text));
		else
			fieldAfter(dialog, label).setText(text);
	}

	/** Chooses from the list that the words are for. */
	static void choose(final Container dialog, final String label, final String item)
		throws Exception {
		onEvents(() -> fieldOf(dialog, label, JComboBox.class).setSelectedItem(item));
	}

	/** Sets the box with these words. */
	static void set(final Container dialog, final String label, final boolean wanted)
		throws Exception {
		onEvents(() -> {
			final JCheckBox box = all(dialog, JCheckBox.class).stream()
				.filter(b -> b.getText().startsWith(label)).findFirst().orElseThrow();
			if (box.isSelected() != wanted)
				box.doClick(0);
		});
	}

	private static <T extends Component> T fieldOf(final Container dialog, final String label,
		final Class<T> kind) {
		return all(dialog, JLabel.class).stream()
			.filter(l -> l.getText() != null && l.getText().startsWith(label))
			.filter(l -> kind.isInstance(l.getLabelFor())).map(l -> kind.cast(l.getLabelFor()))
			.findFirst().orElseThrow(() -> new AssertionError(
				"The dialog has no field '" + label + "': " + text(dialog)));
	}

	/** In ImageJ's own dialogs a field follows its words. */
	private static TextField fieldAfter(final Container dialog, final String label) {
		boolean seen = false;
		for (final Component c : all(dialog, Component.class)) {
			if (c instanceof Label words && words.getText().startsWith(label))
				seen = true;
			if (seen && c instanceof TextField field)
				return field;
		}
		throw new AssertionError("The dialog has no field '" + label + "': " + text(dialog));
	}

	/** Names of what a person fills in or presses and that does not say what it is for. */
	static List<String> withoutHelp(final Container container) {
		final List<String> names = new ArrayList<>();
		for (final Component c : container.getComponents())
			if (c instanceof JTextField || c instanceof JComboBox || c instanceof JSpinner
				|| c instanceof AbstractButton button && button.getText() != null
					&& !button.getText().isBlank()) {
				if (((JComponent) c).getToolTipText() == null)
					names.add(c.getClass().getSimpleName() + " " + c.getName());
			} else if (c instanceof Container inner)
				names.addAll(withoutHelp(inner));
		return names;
	}

	static void onEvents(final Runnable work) throws Exception {
		EventQueue.invokeAndWait(work);
	}

	static void press(final Container container, final String label) {
		all(container, JButton.class).stream()
			.filter(b -> b.getText() != null && b.getText().strip().equals(label.strip()))
			.forEach(b -> EventQueue.invokeLater(b::doClick));
		for (final Button button : all(container, Button.class))
			if (button.getLabel().strip().equals(label.strip()))
				for (final var listener : button.getActionListeners())
					listener.actionPerformed(
						new ActionEvent(button, ActionEvent.ACTION_PERFORMED, button.getLabel()));
	}

	static void await(final String what, final Callable<Boolean> condition) throws Exception {
		final long end = System.currentTimeMillis() + PATIENCE_MILLIS;
		while (!condition.call()) {
			if (System.currentTimeMillis() > end)
				throw new AssertionError("Waited in vain for " + what + "; there are "
					+ dialogs().map(d -> d.getTitle() + ": " + text(d)).toList() + "." + threads());
			Thread.sleep(20);
		}
	}

	/** Where all threads are, a line each. */
	private static String threads() {
		return Thread.getAllStackTraces().entrySet().stream()
			.map(t -> "\n" + t.getKey().getName() + ": " + Arrays.toString(t.getValue()))
			.collect(Collectors.joining());
	}
}
