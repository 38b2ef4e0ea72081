package io.github.knotresolver.ui;

import java.awt.BorderLayout;
import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;

import ij.ImageListener;
import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.Roi;
import ij.gui.RoiListener;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.ImageSelection;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.imagej.form.FormField;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.MovieSource;
import io.github.knotresolver.ui.model.PreviewModel;

/**
 * {@code Preview} in a dialog: the frame that the image shows as the program sees it, drawn on the
 * image as long as the dialog is open, in one line of words, and what is to be known of the movie
 * before the work. It follows the values, the image's slider and its selections. Of a movie that is
 * named as a file, which is read in the background, the words are of its first frame.
 */
public final class PreviewBox implements FormCompanion, ImageListener, RoiListener {

	private static final String NO_WORDS = " ", IMAGE = "image", MOVIE = "movie";

	private final PreviewModel model = new PreviewModel();
	private final JCheckBox box = new JCheckBox("Preview");
	private final Sentences line = new Sentences(), checks = new Sentences();
	private Optional<LookLayer> layer = Optional.empty();
	private Optional<NamedFile> file = Optional.empty();
	private Map<String, String> texts = Map.of();
	private Runnable resized = () -> {
	};
	private boolean closed;

	/** It is on at first, unless the active image is larger than memory may be. */
	public PreviewBox() {
		final ImagePlus image = WindowManager.getCurrentImage();
		box.setSelected(image == null || !image.getStack().isVirtual());
		model.listen(() -> SwingUtilities.invokeLater(this::show));
	}

	@Override
	public JComponent panel(final Runnable whenResized) {
		resized = whenResized;
		box.setName("preview");
		box.setMnemonic('P');
		box.setToolTipText(
			"Draw mask outline, skeleton and course of the frame that the image shows; of a file, say what its first frame shows (Alt-P)");
		box.addActionListener(e -> ask());
		line.setName("line");
		line.show(NO_WORDS);
		final JPanel all = new JPanel(new BorderLayout());
		all.add(box, BorderLayout.NORTH);
		all.add(line, BorderLayout.CENTER);
		all.add(checks, BorderLayout.SOUTH);
		ImagePlus.addImageListener(this);
		Roi.addRoiListener(this);
		return all;
	}

	@Override
	public Optional<Window> beside() {
		return image().map(ImagePlus::getWindow);
	}

	/** The image that is chosen in the dialog; only one that is seen. */
	private Optional<ImagePlus> image() {
		final String title = texts.getOrDefault(IMAGE, "");
		final Optional<ImagePlus> chosen = title.isEmpty()
			? Optional.ofNullable(WindowManager.getCurrentImage())
			: FormField.openImage(title);
		return chosen.filter(i -> i.getWindow() != null && i.getCanvas() != null);
	}

	@Override
	public void changed(final Map<String, String> present) {
		texts = present;
		ask();
	}

	private void ask() {
		final String movie = texts.getOrDefault(MOVIE, "").strip();
		final Optional<ImagePlus> image = image().filter(i -> movie.isEmpty());
		if (!box.isSelected() || closed || image.isEmpty() && movie.isEmpty())
			stop();
		else if (movie.isEmpty())
			ask(image.get());
		else
			askFile(movie);
	}

	private void ask(final ImagePlus image) {
		if (layer.filter(l -> l.isOf(image)).isEmpty()) {
			stop();
			layer = Optional.of(new LookLayer(image));
		}
		ask(layer.get().source(), () -> options(image), ImageLink.frame(image));
	}

	private void askFile(final String name) {
		final Path path;
		try {
			path = Path.of(name).toAbsolutePath().normalize();
		} catch (final InvalidPathException e) {
			stop();
			say("There is no file " + name + ".");
			return;
		}
		if (file.flatMap(NamedFile::file).filter(path::equals).isEmpty()) {
			stop();
			file = Optional.of(new NamedFile(ImageSource.kept(path)));
		}
		ask(file.get(), () -> RunOptions.parse(known()), 1);
	}

	/**
	 * The movie in a file that is there, looked for when it is read: a disk may be slow. Folders of
	 * frames may be large, and are named on the way to a file.
	 */
	private record NamedFile(ImageSource source) implements MovieSource {

		@Override
		public Movie read(final InputOptions options, final Progress progress) {
			final Path path = source.file().orElseThrow();
			if (!Files.isRegularFile(path))
				throw new UserException(Files.isDirectory(path)
					? "The preview looks at files and open images; OK opens the folder."
					: "There is no file " + path + ".");
			return source.read(options, progress);
		}

		@Override
		public Optional<Path> file() {
			return source.file();
		}
	}

	private void ask(final MovieSource source, final Supplier<RunOptions> options,
		final int frame) {
		try {
			model.ask(new PreviewModel.Question(source, options.get(), frame));
		} catch (final UserException e) {
			// A value that is still being typed; OK says what is wrong with it.
			return;
		}
	}

	private RunOptions options(final ImagePlus image) {
		final Map<String, String> known = known();
		// A Z-stack is asked about after OK.
		if (ImageMovie.isTimeElsewhere(image))
			known.put("z_as_time", "true");
		return RunOptions.parse(ImageSelection.over(known, image));
	}

	/** What decides how frames look. */
	private Map<String, String> known() {
		final Map<String, String> known = new LinkedHashMap<>(texts);
		known.keySet().retainAll(RunOptions.KEYS);
		known.keySet().removeAll(List.of("threads", "corrections"));
		return known;
	}

	private void stop() {
		model.off();
		layer.ifPresent(LookLayer::close);
		layer = Optional.empty();
		file = Optional.empty();
		say(NO_WORDS);
	}

	private void say(final String sentence) {
		if (line.show(sentence))
			resized.run();
	}

	private void show() {
		if (closed)
			return;
		layer.ifPresent(l -> l.show(model.look()));
		if ((layer.isPresent() || file.isPresent())
			&& (!model.isWorking() || model.look().isEmpty()))
			say(model.isWorking() ? "Looking ..." : model.line());
		if (checks.show(model.checks()))
			resized.run();
	}

	@Override
	public void imageOpened(final ImagePlus image) {
		// The dialog's list of images tells.
	}

	@Override
	public void imageClosed(final ImagePlus image) {
		SwingUtilities.invokeLater(() -> {
			if (layer.filter(l -> l.isOf(image)).isPresent())
				stop();
		});
	}

	@Override
	public void imageUpdated(final ImagePlus image) {
		follow(image);
	}

	@Override
	public void roiModified(final ImagePlus image, final int id) {
		follow(image);
	}

	private void follow(final ImagePlus image) {
		SwingUtilities.invokeLater(() -> {
			if (layer.filter(l -> l.isOf(image)).isPresent())
				ask();
		});
	}

	/** The image is as it was before. */
	@Override
	public void close() {
		closed = true;
		ImagePlus.removeImageListener(this);
		Roi.removeRoiListener(this);
		layer.ifPresent(LookLayer::close);
		layer = Optional.empty();
		file = Optional.empty();
		model.close();
	}
}
