package io.github.knotresolver.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.imagej.TestImages;

/** What the preview says of movies that are named as files, without a display. */
class PreviewBoxTest {

	private static final int PATIENCE_SECONDS = 60;

	@TempDir
	Path home;
	private PreviewBox box;
	private JComponent panel;

	@BeforeEach
	void open() throws Exception {
		SwingUtilities.invokeAndWait(() -> {
			box = new PreviewBox();
			panel = box.panel(() -> {
			});
		});
	}

	@AfterEach
	void close() throws Exception {
		SwingUtilities.invokeAndWait(box::close);
	}

	private void changed(final Map<String, String> texts) throws Exception {
		SwingUtilities.invokeAndWait(() -> box.changed(texts));
	}

	/** Waits for words. */
	private String said(final Predicate<String> wanted) throws Exception {
		final String[] words = new String[1];
		for (int i = 0; i < PATIENCE_SECONDS * 20; i++) {
			SwingUtilities.invokeAndWait(() -> words[0] = words(panel).replace('\n', ' '));
			if (wanted.test(words[0]))
				break;
			Thread.sleep(50);
		}
		return words[0];
	}

	private static String words(final Component part) {
		if (part instanceof JTextComponent text)
			return text.getText();
		return part instanceof Container c
			? Stream.of(c.getComponents()).map(PreviewBoxTest::words).filter(w -> !w.isBlank())
				.collect(Collectors.joining("|"))
			: "";
	}

	@Test
	void theFirstFrameOfAFileIsToldAndFollowsTheValues() throws Exception {
		final Path movie = TestImages.save(SampleMovie.open(), home.resolve("movie.tif"));
		changed(Map.of("movie", movie.toString()));
		final String first = said(w -> w.startsWith("frame 1: 1 filament, "));
		assertTrue(first.matches("frame 1: 1 filament, width 3\\.\\d px, bright on dark, .*"),
			first);
		changed(Map.of("movie", movie.toString(), "threshold", "nonsense"));
		changed(Map.of("movie", movie.toString(), "polarity", "dark"));
		assertTrue(said(w -> w.contains("Polarity: dark lines")).contains("Polarity: dark lines"));
		changed(Map.of("movie", ""));
		assertEquals("", said(String::isEmpty));
	}

	@Test
	void aFileThatIsNoMovieIsSaidBeforeOk() throws Exception {
		final Path text = Files.writeString(home.resolve("notes.tif"), "no movie");
		changed(Map.of("movie", text.toString()));
		assertTrue(said(w -> w.contains("is not an image")).contains("is not an image"));
		final Path none = home.resolve("none.tif");
		changed(Map.of("movie", none.toString()));
		assertEquals("There is no file " + none + ".", said(w -> w.startsWith("There is")));
		changed(Map.of("movie", home.toString()));
		assertTrue(said(w -> w.contains("OK opens the folder")).contains("OK opens the folder"));
		SwingUtilities.invokeAndWait(() -> ((JCheckBox) panel.getComponent(0)).doClick());
		assertEquals("", said(String::isEmpty));
	}
}
