package io.github.knotresolver.ui;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.io.IOException;
import java.util.Optional;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

import ij.IJ;
import ij.ImageListener;
import ij.ImagePlus;
import ij.gui.GUI;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.ui.model.RunModel;
import io.github.knotresolver.ui.model.RunOutcome;

/**
 * A run as a person watches it. A small window with Cancel comes up after two seconds; contours
 * appear on the image as they are found; at the end the window says how many frames are right,
 * doubtful and lost, with a button that opens the review. One window at a time.
 */
public final class RunWindow implements ImageListener, AutoCloseable {

	private static final int PATIENCE = 2000, TICK = 200, GAP = 8, PERCENT = 100;

	private static RunWindow last;

	private final RunModel model;
	private final ImagePlus image;
	private final JFrame window;
	private final JLabel line = new JLabel("Beginning");
	private final JProgressBar bar = new JProgressBar(0, PERCENT);
	private final JButton cancel = new JButton("Cancel"), review = new JButton("Review");
	private final Timer timer = new Timer(TICK, e -> tick());
	private final long start = System.currentTimeMillis();
	private final Optional<LookLayer> layer;
	private boolean running = true;

	private RunWindow(final RunModel model, final ImagePlus image) {
		this.model = model;
		this.image = image;
		layer = image.getWindow() == null ? Optional.empty() : Optional.of(new LookLayer(image));
		window = new JFrame("Resolving " + image.getTitle());
		build();
	}

	/**
	 * Begins to watch, in place of the run before.
	 *
	 * @param model the run
	 * @param image what is resolved
	 * @return to be closed if there is no result
	 */
	public static RunWindow watch(final RunModel model, final ImagePlus image) {
		final RunWindow[] watch = new RunWindow[1];
		EventThread.run(() -> {
			if (last != null)
				last.end();
			last = new RunWindow(model, image);
			watch[0] = last;
			last.timer.start();
		});
		return watch[0];
	}

	private void build() {
		line.setName("run");
		bar.setName("bar");
		cancel.setName("Cancel");
		cancel.setToolTipText("Stop; nothing is written (Esc, also in ImageJ's windows)");
		cancel.addActionListener(e -> stop());
		review.setName("Review");
		review.setToolTipText("Look at the doubtful frames and mend them");
		review.setVisible(false);
		review.addActionListener(e -> review());
		final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, GAP, 0));
		buttons.add(review);
		buttons.add(cancel);
		final JPanel all = new JPanel(new BorderLayout(GAP, GAP));
		all.setBorder(BorderFactory.createEmptyBorder(GAP, GAP, GAP, GAP));
		all.add(line, BorderLayout.NORTH);
		all.add(bar, BorderLayout.CENTER);
		all.add(buttons, BorderLayout.SOUTH);
		window.setContentPane(all);
		window.setAutoRequestFocus(false);
		WindowActions.onClosing(window, this::stop);
		WindowActions.onKey(window.getRootPane(), "ESCAPE", this::stop);
		ImagePlus.addImageListener(this);
	}

	private void tick() {
		line.setText(model.line());
		bar.setValue((int) (PERCENT * model.done()));
		layer.ifPresent(l -> l.show(model.sightings()));
		if (!window.isVisible() && System.currentTimeMillis() - start > PATIENCE)
			open();
	}

	private void open() {
		GuiFont.scale(window.getContentPane());
		final int em = line.getFontMetrics(line.getFont()).getHeight();
		window.getContentPane().setPreferredSize(null);
		final var size = window.getContentPane().getPreferredSize();
		size.width = Math.max(size.width, 26 * em);
		window.getContentPane().setPreferredSize(size);
		window.pack();
		if (!window.isVisible()) {
			if (image.getWindow() == null)
				GUI.centerOnImageJScreen(window);
			else
				Beside.place(window, image.getWindow());
		}
		window.setVisible(true);
	}

	/** While it runs, the run is asked to stop; after that the window goes. */
	private void stop() {
		if (running) {
			model.cancel();
			line.setText("Stopping");
			cancel.setEnabled(false);
		} else
			end();
	}

	/** The contours that were drawn go, before those of the result come. */
	public void clear() {
		EventThread.run(() -> {
			timer.stop();
			layer.ifPresent(LookLayer::close);
		});
	}

	/**
	 * Says what came of it.
	 *
	 * @param tracks the result
	 */
	public void done(final Tracks tracks) {
		EventThread.run(() -> {
			running = false;
			timer.stop();
			if (image.getWindow() == null) {
				end();
				return;
			}
			window.setTitle("Resolved " + image.getTitle());
			line.setText(RunOutcome.of(tracks).line());
			bar.setVisible(false);
			review.setVisible(true);
			cancel.setText("Close");
			cancel.setToolTipText("Esc");
			cancel.setEnabled(true);
			window.getRootPane().setDefaultButton(review);
			open();
		});
	}

	private void review() {
		new Thread(() -> {
			try {
				Reviews.ofImage(image, false, () -> {
				});
				SwingUtilities.invokeLater(this::end);
			} catch (final IOException | RuntimeException | Error e) {
				IJ.showMessage("Review Result...",
					Failure.of(e, "give Java more memory").sentence());
			}
		}, "KnotResolver review opens").start();
	}

	@Override
	public void imageOpened(final ImagePlus other) {
		// Of no interest.
	}

	@Override
	public void imageClosed(final ImagePlus other) {
		if (other == image)
			SwingUtilities.invokeLater(() -> {
				if (!running)
					end();
			});
	}

	@Override
	public void imageUpdated(final ImagePlus other) {
		// Of no interest.
	}

	/** There is no result: the window goes; nothing if there is one. */
	@Override
	public void close() {
		EventThread.run(() -> {
			if (running)
				end();
		});
	}

	private void end() {
		running = false;
		timer.stop();
		layer.ifPresent(LookLayer::close);
		ImagePlus.removeImageListener(this);
		window.dispose();
		if (last == this)
			last = null;
	}
}
