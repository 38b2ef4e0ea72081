package io.github.knotresolver.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;

import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;

import ij.ImagePlus;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.ui.model.ReviewModel;

/**
 * {@code Review Result...}: beside ImageJ's image, what is known of each frame, where to look, and
 * what can be said about it. All of it is in {@link ReviewModel}; here it is painted.
 */
public final class ReviewWindow {

	/** Of the height that a person gives the window, what each of two rows of pictures takes. */
	private static final double SHARE = 0.4;

	/** The windows that are open, by their image. */
	private static final Map<ImagePlus, ReviewWindow> OPEN = new ConcurrentHashMap<>();

	private final ReviewedResult result;
	private final ReviewModel model;
	private final ImagePlus image;
	private final Runnable closed;
	private final ImageLink link;
	private final JFrame window;
	private final ImageKeys keys;
	private final JLabel headline = new JLabel(" "), status = new JLabel(" ");
	private final JTextArea frame = new JTextArea(2, 40);
	private final ConfidenceStrip strip;
	private final MeetingStrip meetings;
	private final FrameViews views;
	private final AtomicInteger saving = new AtomicInteger();
	/** Of the window, as it was made last, and what a person added to its height. */
	private int width, height, extra;
	private boolean gone;

	private ReviewWindow(final ReviewedResult result, final ImagePlus image,
		final Runnable closed) {
		this.result = result;
		this.image = image;
		this.closed = closed;
		model = result.model();
		strip = new ConfidenceStrip(model);
		meetings = new MeetingStrip(model);
		views = new FrameViews(model, this::hover);
		link = new ImageLink(image, result.channel(), model, () -> leave(false));
		window = new JFrame("Review " + result.name());
		keys = new ImageKeys(image, window.getRootPane());
	}

	/**
	 * Opens a window beside an image. Called by the thread of events.
	 *
	 * @param result what is reviewed; closed with the window
	 * @param image its movie, shown in a window
	 * @param closed called when the window has been closed
	 * @return the window
	 */
	public static ReviewWindow open(final ReviewedResult result, final ImagePlus image,
		final Runnable closed) {
		final ReviewWindow review = new ReviewWindow(result, image, closed);
		OPEN.put(image, review);
		review.build();
		return review;
	}

	/**
	 * @param image an image
	 * @return whether its review is open; it is brought to the front then
	 */
	public static boolean toFront(final ImagePlus image) {
		final ReviewWindow open = image == null ? null : OPEN.get(image);
		if (open != null)
			SwingUtilities.invokeLater(open.window::toFront);
		return open != null;
	}

	/**
	 * @param image an image
	 * @param filament number of a filament
	 * @param frame from 1
	 * @return whether its review is open; it has gone there then
	 */
	static boolean goTo(final ImagePlus image, final int filament, final int frame) {
		final ReviewWindow open = OPEN.get(image);
		if (open != null) {
			open.model.choose(filament);
			open.model.goTo(frame);
		}
		return open != null;
	}

	private void build() {
		frame.setEditable(false);
		frame.setFocusable(false);
		frame.setLineWrap(true);
		frame.setWrapStyleWord(true);
		frame.setOpaque(false);
		frame.setFont(headline.getFont());
		frame.setName("frame");
		status.setName("status");
		headline.setName("headline");
		final JPanel middle = new JPanel();
		middle.setLayout(new BoxLayout(middle, BoxLayout.Y_AXIS));
		for (final Component part : List.of(frame, new JLabel("Alternatives, cheapest first"),
			views.alternatives(), new JLabel("Neighbours"), views.neighbours(),
			new ReviewActions(model, image, this::say, this::save).in(window.getRootPane()))) {
			((JComponent) part).setAlignmentX(Component.LEFT_ALIGNMENT);
			middle.add(part);
			middle.add(Box.createVerticalStrut(4));
		}
		final JPanel below = new JPanel(new BorderLayout(4, 4));
		below.add(middle, BorderLayout.CENTER);
		below.add(status, BorderLayout.SOUTH);
		final JPanel all = new JPanel(new BorderLayout(4, 4));
		all.setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
		final JPanel above = new JPanel(new BorderLayout(4, 4));
		above.add(headline, BorderLayout.NORTH);
		above.add(new JLabel(ReviewWords.LEGEND), BorderLayout.SOUTH);
		all.add(above, BorderLayout.NORTH);
		final JPanel strips = new JPanel(new BorderLayout());
		strips.add(strip, BorderLayout.CENTER);
		strips.add(meetings, BorderLayout.SOUTH);
		all.add(strips, BorderLayout.CENTER);
		all.add(below, BorderLayout.SOUTH);
		window.setContentPane(all);
		WindowActions.onClosing(window, () -> leave(true));
		model.listen(new Soon(this::refresh));
		GuiFont.scale(all);
		refresh();
		window.pack();
		Beside.keepOnScreen(window);
		width = window.getWidth();
		height = window.getHeight();
		window.setMinimumSize(new Dimension(window.getWidth() / 2, height));
		Beside.place(window, image.getWindow());
		window.setVisible(true);
		window.addComponentListener(new ComponentAdapter() {

			@Override
			public void componentResized(final ComponentEvent e) {
				if (window.getHeight() != height || window.getWidth() != width)
					resized();
			}
		});
	}

	private void say(final String sentence) {
		status.setText(sentence);
	}

	private void hover(final Optional<Polyline> contour) {
		if (!gone)
			link.show(contour);
	}

	private void refresh() {
		if (gone)
			return;
		headline.setText(ReviewWords.headline(model));
		frame.setText(ReviewWords.frame(model));
		if (saving.get() == 0)
			status.setText(ReviewWords.status(model, result.isChanged()));
		link.show(Optional.empty());
		model.track().ifPresent(t -> views.refresh(t, SHARE * extra));
		strip.refresh();
		meetings.refresh();
		grow();
	}

	/** As high as its contents need, and within the screen. */
	private void grow() {
		final int wanted = window.getPreferredSize().height;
		if (!window.isVisible() || wanted <= window.getHeight())
			return;
		Beside.resize(window, window.getWidth(), wanted);
		width = window.getWidth();
		height = window.getHeight();
	}

	/** What a person gives in height is for strip and pictures. */
	private void resized() {
		extra = Math.max(0, extra + window.getHeight() - height);
		width = window.getWidth();
		height = window.getHeight();
		window.validate();
		Wrapping.countAnew(window.getContentPane());
		refresh();
	}

	/** Once the key's letter has arrived, which would be the name of the folder otherwise. */
	private void save() {
		SwingUtilities.invokeLater(() -> {
			if (!gone && saving.get() == 0 && hasFolder()) {
				saving.set(1);
				SavedResult.inBackground(result, this::say, () -> saving.set(0));
			}
		});
	}

	private boolean hasFolder() {
		try {
			return result.folder().isPresent() || SavedResult.chooseFolder(result, window);
		} catch (final UserException e) {
			say(e.getMessage());
			return false;
		}
	}

	/** Closes; asks first whether to save what was said, if a person can still choose. */
	private void leave(final boolean canStay) {
		if (gone)
			return;
		if (result.isChanged()) {
			final int answer = JOptionPane.showConfirmDialog(window,
				"Save the corrections of " + result.name() + "?", "Review",
				canStay ? JOptionPane.YES_NO_CANCEL_OPTION : JOptionPane.YES_NO_OPTION);
			if (canStay && answer != JOptionPane.YES_OPTION && answer != JOptionPane.NO_OPTION)
				return;
			if (answer == JOptionPane.YES_OPTION) {
				if (!hasFolder() && canStay)
					return;
				SavedResult.inBackground(result, this::say, () -> {
					if (!result.isChanged())
						end();
				});
				return;
			}
		}
		end();
	}

	private void end() {
		if (gone)
			return;
		gone = true;
		OPEN.remove(image);
		keys.close();
		link.close();
		result.close();
		window.dispose();
		closed.run();
	}
}
