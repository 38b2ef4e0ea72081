package io.github.knotresolver.ui;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;

import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JRootPane;

import ij.ImagePlus;
import ij.plugin.frame.RoiManager;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ResultDisplay;
import io.github.knotresolver.imagej.RoiConverter;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.ui.model.ReviewModel;

/** What a person can do in a review: each by a button and by a key. */
final class ReviewActions {

	/** As many as there are digits beside that of the contour that is shown. */
	static final int MOST_ALTERNATIVES = 8;

	private static final int GAP = 4;

	private final ReviewModel model;
	private final ImagePlus image;
	private final Consumer<String> say;
	private final Runnable save;

	/**
	 * @param model what is said goes there
	 * @param image has the selections
	 * @param say told what is missing, one sentence
	 * @param save saves
	 */
	ReviewActions(final ReviewModel model, final ImagePlus image, final Consumer<String> say,
		final Runnable save) {
		this.model = model;
		this.image = image;
		this.say = say;
		this.save = save;
	}

	/** @return the buttons; their keys work in the whole window */
	JPanel in(final JRootPane root) {
		final Row correct = new Row(root), go = new Row(root);
		correct.add("Pass through", "T", "The contour passes the image's point selection",
			() -> atPoint(model::through));
		correct.add("Tip is here", "E", "The contour ends at the image's point selection",
			() -> atPoint(model::tip));
		correct.add("Not this one", "X", "The contour that is shown is wrong", model::refuse);
		correct.add("Draw", "D", "The image's line selection is the whole contour, fixed end first",
			this::draw);
		correct.add("Swap with...", "O",
			"From this frame on, this filament is another one, and that one is this",
			() -> exchange(correct.panel));
		correct.add("From ROI Manager", "M",
			"Take over contours that you changed in the ROI Manager (drag a polyline, Update)",
			this::takeOver);
		correct.add("Withdraw", "W", "Forget all that was said about this frame", model::withdraw);
		go.add("Previous doubtful", "P", "The more doubtful frame before", model::previousDoubtful);
		go.add("Next doubtful", "N", "The least certain frame, then the others",
			model::nextDoubtful);
		go.add("Accept", "SPACE", "What is shown is right; on to the next doubtful frame", () -> {
			model.accept();
			model.nextDoubtful();
		});
		go.add("Undo", "ctrl Z", "Take back the last step", model::undo);
		go.add("Redo", "ctrl Y", "Do it again", model::redo);
		go.add("Save", "S", "Write corrections.csv and the result", save);
		walk(root);
		final JPanel both = new JPanel();
		both.setLayout(new BoxLayout(both, BoxLayout.Y_AXIS));
		both.add(correct.panel);
		both.add(go.panel);
		return both;
	}

	private void walk(final JRootPane root) {
		WindowActions.onKey(root, "LEFT", () -> model.goTo(model.frame() - 1));
		WindowActions.onKey(root, "RIGHT", () -> model.goTo(model.frame() + 1));
		WindowActions.onKey(root, "UP", () -> model.choose(model.filament() - 1));
		WindowActions.onKey(root, "DOWN", () -> model.choose(model.filament() + 1));
		WindowActions.onKey(root, "1", model::accept);
		for (int i = 0; i < MOST_ALTERNATIVES; i++) {
			final int index = i;
			WindowActions.onKey(root, Integer.toString(i + 2), () -> model.take(index));
		}
	}

	private void atPoint(final Consumer<Point> word) {
		RoiConverter.point(image.getRoi()).ifPresentOrElse(word, () -> say
			.accept("Click the place with ImageJ's point tool first, or drag the contour there."));
	}

	/** With the only other filament, or with one that is chosen from a list. */
	private void exchange(final JComponent place) {
		final List<Integer> others = model.tracks().map(Tracks::filaments).orElse(List.of())
			.stream().map(FilamentTrack::id).filter(id -> id != model.filament()).toList();
		if (others.isEmpty())
			say.accept("There is no other filament to swap with.");
		else if (others.size() == 1)
			model.exchange(others.get(0));
		else {
			final JPopupMenu menu = new JPopupMenu();
			others.forEach(
				id -> menu.add("Filament " + id).addActionListener(e -> model.exchange(id)));
			menu.show(place, 0, place.getHeight());
		}
	}

	private void draw() {
		final Optional<Polyline> line = RoiConverter.line(image.getRoi());
		line.ifPresentOrElse(model::contour, () -> say.accept(
			"Draw the contour with one of ImageJ's line tools first, from the fixed end to the tip."));
	}

	private void takeOver() {
		final RoiManager manager = RoiManager.getInstance2();
		final int taken = manager == null
			? 0
			: model.takeOver(ResultDisplay.contours(manager, image));
		say.accept(taken == 0
			? "No contour in the ROI Manager is otherwise than here; drag one, and press Update there."
			: taken + (taken == 1 ? " contour is" : " contours are")
				+ " taken over from the ROI Manager.");
	}

	/** Buttons beside each other. */
	private static final class Row {

		private final JRootPane root;
		private final JPanel panel = new JPanel(new Wrapping(GAP, GAP / 2));

		Row(final JRootPane root) {
			this.root = root;
		}

		void add(final String words, final String key, final String help, final Runnable action) {
			// As ImageJ's ROI Manager names its keys.
			final JButton button = new JButton(words + " [" + key.toLowerCase(Locale.ROOT) + "]");
			button.setName(words);
			// The space bar accepts, wherever one clicked last.
			button.setFocusable(false);
			button.setToolTipText(help + " (key: " + key.toLowerCase(Locale.ROOT) + ")");
			button.addActionListener(e -> action.run());
			panel.add(button);
			WindowActions.onKey(root, key, action);
		}
	}
}
