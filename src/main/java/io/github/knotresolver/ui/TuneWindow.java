package io.github.knotresolver.ui;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.SwingUtilities;

import ij.ImageListener;
import ij.ImagePlus;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.LookOverlay;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.io.SheetRow;
import io.github.knotresolver.ui.model.TuneModel;

/**
 * {@code Tune Segmentation...}: beside ImageJ's image, the values of the segmentation and what they do in
 * this frame and over the whole movie. All of it is in {@link TuneModel}; here it is painted.
 */
public final class TuneWindow implements ImageListener {

	private static final int GAP = 6;

	private final TuneModel model;
	private final ImagePlus image;
	private final int channel;
	private final Consumer<Map<String, String>> use;
	private final LookLayer layer;
	private final JFrame window;
	private final JLabel line = new JLabel(" "), said = new JLabel(" ");
	private final HistogramView histogram;
	private final FrameStrip strip;
	private final TuneValues values;
	private boolean gone;
	/** The model's frame when the image was made to follow it last. */
	private int frame;

	private TuneWindow(final TuneModel model, final ImagePlus image, final int channel,
		final Consumer<Map<String, String>> use) {
		this.model = model;
		this.image = image;
		this.channel = channel;
		this.use = use;
		layer = new LookLayer(image);
		histogram = new HistogramView(model);
		strip = new FrameStrip(model);
		values = new TuneValues(model);
		window = new JFrame("Tune " + image.getTitle());
	}

	/**
	 * Opens a window beside an image.
	 *
	 * @param model closed with the window
	 * @param image its movie, shown in a window
	 * @param channel that is looked at, from 1
	 * @param use told the values that {@code Resolve Filament...} is to begin with
	 */
	public static void open(final TuneModel model, final ImagePlus image, final int channel,
		final Consumer<Map<String, String>> use) {
		EventThread.run(() -> new TuneWindow(model, image, channel, use).build());
	}

	/**
	 * @param image an image
	 * @return the frame that it shows, from 1
	 */
	public static int frame(final ImagePlus image) {
		return ImageLink.frame(image);
	}

	private void build() {
		line.setName("line");
		said.setName("said");
		final JPanel all = new JPanel();
		all.setLayout(new BoxLayout(all, BoxLayout.Y_AXIS));
		all.setBorder(BorderFactory.createEmptyBorder(GAP, GAP, GAP, GAP));
		for (final Component part : List.of(line, histogram, values.panel(), new JLabel(
			"Over the movie: size of the mask; orange with a mark: several objects; cross: none"),
			strip, parts(), buttons(), said)) {
			((JComponent) part).setAlignmentX(0);
			all.add(part);
			all.add(Box.createVerticalStrut(GAP));
		}
		window.setContentPane(all);
		WindowActions.onClosing(window, this::end);
		final JRootPane root = window.getRootPane();
		WindowActions.onKey(root, "ESCAPE", this::end);
		WindowActions.onKey(root, "ctrl LEFT", () -> model.goTo(model.frame() - 1));
		WindowActions.onKey(root, "ctrl RIGHT", () -> model.goTo(model.frame() + 1));
		ImagePlus.addImageListener(this);
		model.listen(new Soon(this::refresh));
		refresh();
		GuiFont.scale(all);
		// In a larger window histogram and strip are higher, and nothing else is.
		for (final Component part : all.getComponents())
			if (part != histogram && part != strip)
				part.setMaximumSize(new Dimension(Short.MAX_VALUE, part.getPreferredSize().height));
		window.pack();
		window.setMinimumSize(window.getSize());
		Beside.place(window, image.getWindow());
		window.setVisible(true);
	}

	private JPanel parts() {
		final JPanel row = new JPanel(new FlowLayout(FlowLayout.LEFT, GAP, 0));
		final JCheckBox outline = new JCheckBox("Outline", true),
			skeleton = new JCheckBox("Skeleton", true), course = new JCheckBox("Course", false);
		for (final JCheckBox box : List.of(outline, skeleton, course)) {
			box.setName(box.getText());
			box.setToolTipText("Draw it on the image");
			box.addActionListener(e -> layer.show(new LookOverlay.Parts(outline.isSelected(),
				skeleton.isSelected(), course.isSelected())));
			row.add(box);
		}
		layer.show(new LookOverlay.Parts(true, true, false));
		return row;
	}

	private JPanel buttons() {
		final JPanel row = new JPanel(new FlowLayout(FlowLayout.LEFT, GAP, 0));
		button(row, "Automatic", "All values as they are by default", model::reset);
		button(row, "Save to sheet...", "Write the movie's row of a batch sheet", this::save);
		button(row, "Use in Resolve", "Resolve Filament... with these values", () -> {
			final Map<String, String> texts = model.texts();
			end();
			use.accept(texts);
		});
		button(row, "Close", "The image is as before (Esc)", this::end);
		return row;
	}

	private static void button(final JPanel row, final String words, final String help,
		final Runnable action) {
		final JButton button = new JButton(words);
		button.setName(words);
		button.setMnemonic(words.charAt(0));
		button.setToolTipText(help);
		button.addActionListener(e -> action.run());
		row.add(button);
	}

	private void save() {
		final Optional<Path> movie = ImageFile.of(image);
		if (movie.isEmpty()) {
			said.setText("The movie has no file; save it first, a row names the file.");
			return;
		}
		final JFileChooser chooser = new JFileChooser(movie.get().getParent().toFile());
		chooser.setDialogTitle("Batch sheet (CSV), new or present");
		chooser.setSelectedFile(new File(movie.get().getParent().toFile(), "sheet.csv"));
		if (chooser.showDialog(window, "Write the row") == JFileChooser.APPROVE_OPTION)
			save(new SheetRow(chooser.getSelectedFile().toPath(), movie.get()),
				chooser.getSelectedFile());
	}

	private void save(final SheetRow row, final File sheet) {
		try {
			if (row.isThere() && JOptionPane.showConfirmDialog(window,
				sheet.getName() + " has a row for this movie. Replace its values?", "Save to sheet",
				JOptionPane.YES_NO_OPTION) != JOptionPane.YES_OPTION)
				return;
			row.write(model.texts(), true);
			said.setText(
				"Written: the row of " + image.getTitle() + " in " + sheet.getName() + ".");
		} catch (final IOException | RuntimeException e) {
			said.setText(Failure.of(e, "give Java more memory").sentence());
		}
	}

	private void refresh() {
		if (gone)
			return;
		values.refresh();
		line.setText(model.line().isEmpty() ? " " : model.line());
		// The slider may be ahead of what is known here: the image follows the model's steps alone.
		if (model.frame() != frame) {
			frame = model.frame();
			if (ImageLink.frame(image) != frame)
				ImageLink.goTo(image, channel, frame);
		}
		layer.show(model.look().filter(l -> l.frame() == model.frame()));
		histogram.repaint();
		strip.repaint();
	}

	@Override
	public void imageOpened(final ImagePlus other) {
		// Of no interest.
	}

	@Override
	public void imageClosed(final ImagePlus other) {
		if (other == image)
			SwingUtilities.invokeLater(this::end);
	}

	@Override
	public void imageUpdated(final ImagePlus other) {
		if (other == image)
			SwingUtilities.invokeLater(() -> {
				if (!gone)
					model.goTo(ImageLink.frame(image));
			});
	}

	/** The image is as it was before. */
	private void end() {
		if (gone)
			return;
		gone = true;
		ImagePlus.removeImageListener(this);
		layer.close();
		model.close();
		window.dispose();
	}
}
