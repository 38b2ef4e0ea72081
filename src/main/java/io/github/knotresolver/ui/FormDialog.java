package io.github.knotresolver.ui;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.FlowLayout;
import java.awt.Frame;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;

import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.WindowConstants;

import ij.IJ;
import ij.gui.GUI;
import ij.plugin.BrowserLauncher;
import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.FormGroups;
import io.github.knotresolver.model.UserException;

/**
 * A form as a dialog. It stays open until its values are allowed or the user gives up: a wrong one is
 * marked, with the sentence above the buttons. It does not block ImageJ's other windows, so that one
 * can look at other frames and select places in the image meanwhile; the thread that asks waits.
 * Nothing is recorded here.
 */
public final class FormDialog {

	private static final int GAP = 6;

	/** Those that are open, by their title: one of each is enough. */
	private static final Map<String, FormDialog> OPEN = new ConcurrentHashMap<>();

	private final Form form;
	private final Runnable check;
	private final JDialog window;
	private final FormFields fields;
	private final Sentences sentences = new Sentences();
	private final Optional<FormCompanion> companion;
	private final CountDownLatch closed = new CountDownLatch(1);
	private boolean accepted;

	private FormDialog(final Texts words, final Form form, final FormGroups groups,
		final Optional<FormCompanion> companion, final Runnable check) {
		this.form = form;
		this.check = check;
		this.companion = companion;
		window = new JDialog((Frame) IJ.getInstance(), words.title);
		fields = new FormFields(form, groups, this::changed, this::grow);
		build(words);
	}

	/**
	 * What is said around a form.
	 *
	 * @param title of the dialog
	 * @param help address behind the Help button
	 * @param problem what was wrong with the values at first; empty if nothing was
	 */
	public record Texts(String title, String help, Optional<String> problem) {
	}

	/**
	 * Shows a dialog and waits for its end. If one of this title is open already, that comes to the
	 * front, and nothing is filled in.
	 *
	 * @param words around the form
	 * @param form the form
	 * @param groups how it is put before a person
	 * @param companion goes along with it; closed with the dialog
	 * @param check what is to hold of the form as a whole; throws a {@link UserException} if it does
	 *          not
	 * @return whether the form was filled in
	 */
	public static boolean ask(final Texts words, final Form form, final FormGroups groups,
		final Optional<FormCompanion> companion, final Runnable check) {
		final FormDialog present = OPEN.get(words.title);
		if (present != null) {
			companion.ifPresent(FormCompanion::close);
			EventQueue.invokeLater(present.window::toFront);
			return false;
		}
		final FormDialog[] dialog = new FormDialog[1];
		// The thread of events cannot wait for itself.
		final boolean modal = EventQueue.isDispatchThread();
		EventThread.run(() -> {
			dialog[0] = new FormDialog(words, form, groups, companion, check);
			OPEN.put(words.title, dialog[0]);
			dialog[0].open(words.problem, modal);
		});
		return dialog[0].await();
	}

	private void open(final Optional<String> problem, final boolean modal) {
		problem.ifPresent(this::show);
		changed();
		GuiFont.scale(window.getContentPane());
		window.pack();
		grow();
		window.setMinimumSize(window.getSize());
		companion.flatMap(FormCompanion::beside).ifPresentOrElse(
			other -> Beside.place(window, other), () -> GUI.centerOnImageJScreen(window));
		window.setModal(modal);
		window.setVisible(true);
	}

	private boolean await() {
		try {
			closed.await();
		} catch (final InterruptedException e) {
			EventThread.run(this::close);
			Thread.currentThread().interrupt();
		}
		return accepted;
	}

	private void build(final Texts words) {
		final JPanel all = new JPanel(new BorderLayout(GAP, GAP));
		all.setBorder(BorderFactory.createEmptyBorder(2 * GAP, 2 * GAP, GAP, 2 * GAP));
		all.add(fields.panel(), BorderLayout.CENTER);
		final JPanel below = new JPanel();
		below.setLayout(new BoxLayout(below, BoxLayout.Y_AXIS));
		companion.ifPresent(c -> below.add(left(c.panel(this::grow))));
		below.add(left(sentences));
		below.add(Box.createVerticalStrut(GAP));
		below.add(left(buttons(words)));
		all.add(below, BorderLayout.SOUTH);
		window.setContentPane(all);
		window.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
		window.addWindowListener(new WindowAdapter() {

			@Override
			public void windowClosing(final WindowEvent e) {
				close();
			}

			@Override
			public void windowClosed(final WindowEvent e) {
				close();
			}
		});
		WindowActions.onKey(window.getRootPane(), "ESCAPE", this::close);
	}

	private static JComponent left(final JComponent part) {
		part.setAlignmentX(0);
		return part;
	}

	private JPanel buttons(final Texts words) {
		final JButton help = button("Help", "The page of this dialog, in the browser",
			() -> IJ.runPlugIn(BrowserLauncher.class.getName(), words.help));
		final JButton cancel = button("Cancel", "Nothing is done (Esc)", this::close);
		final JButton ok = button("OK", "Begin (Enter)", this::accept);
		window.getRootPane().setDefaultButton(ok);
		final JPanel right = new JPanel(new FlowLayout(FlowLayout.RIGHT, GAP, 0));
		right.add(cancel);
		right.add(ok);
		final JPanel buttons = new JPanel(new BorderLayout());
		buttons.add(help, BorderLayout.WEST);
		buttons.add(right, BorderLayout.EAST);
		return buttons;
	}

	private static JButton button(final String words, final String help, final Runnable action) {
		final JButton button = new JButton(words);
		button.setName(words);
		button.setToolTipText(help);
		button.setMnemonic(words.charAt(0));
		button.addActionListener(e -> action.run());
		return button;
	}

	private void changed() {
		companion.ifPresent(c -> c.changed(fields.texts()));
	}

	/** Fills in the form and closes, unless something is wrong, which is shown then. */
	private void accept() {
		sentences.clear();
		final boolean allowed = fields.fill(sentences::add);
		if (allowed)
			try {
				check.run();
				accepted = true;
				close();
				return;
			} catch (final UserException e) {
				show(e.getMessage());
			}
		grow();
	}

	private void show(final String problem) {
		form.mentioned(problem).ifPresent(fields::mark);
		sentences.add(problem);
	}

	/** As large as its contents, and inside the screen. */
	private void grow() {
		if (!window.isDisplayable())
			return;
		window.pack();
		Beside.keepOnScreen(window);
	}

	private void close() {
		if (closed.getCount() == 0)
			return;
		OPEN.values().remove(this);
		fields.close();
		companion.ifPresent(FormCompanion::close);
		closed.countDown();
		window.dispose();
	}
}
