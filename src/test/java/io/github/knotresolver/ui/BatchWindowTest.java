package io.github.knotresolver.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.io.BatchList;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.ui.model.BatchTable;

/** What a batch shows at its end, painted without a display. */
class BatchWindowTest {

	private static final Color CONTOUR = new Color(0x00, 0x9e, 0x73);

	@TempDir
	Path out;

	private BatchTable table() throws IOException {
		final BufferedImage picture = new BufferedImage(800, 400, BufferedImage.TYPE_INT_RGB);
		final Graphics2D g = picture.createGraphics();
		g.setColor(CONTOUR);
		g.fillRect(0, 0, 800, 400);
		g.dispose();
		ImageIO.write(picture, "png",
			Files.createDirectory(out.resolve("drawn")).resolve("overlay.png").toFile());
		Files.writeString(Files.createDirectory(out.resolve("damaged")).resolve("overlay.png"),
			"no picture");
		Files.createDirectory(out.resolve("plain"));
		return new BatchTable(out, List.of(row("drawn"), row("damaged"), row("plain")));
	}

	private static BatchOutcome row(final String name) {
		return new BatchOutcome(
			new BatchRow(2, "/data/" + name + ".tif", Map.of(), false, List.of()), Status.FINISHED,
			Optional.of(name), "fine");
	}

	@Test
	void everyResultWithAPictureShowsItUndistortedInItsCell() throws Exception {
		final OutcomesTable shown = new OutcomesTable(table());
		final int height = shown.getRowHeight();
		shown.readPictures();
		SwingUtilities.invokeAndWait(() -> {
			assertEquals(height, shown.getRowHeight());
			assertEquals(2.0, ratio((BufferedImage) shown.getValueAt(0, BatchTable.PICTURE)), 0.01);
			assertNull(shown.getValueAt(1, BatchTable.PICTURE));
			assertNull(shown.getValueAt(2, BatchTable.PICTURE));
			assertTrue(coloured(shown, 0) > 500, "painted");
			assertEquals(0, coloured(shown, 1));
		});
	}

	@Test
	void afterTheWindowIsClosedNoPictureIsRead() throws Exception {
		final OutcomesTable shown = new OutcomesTable(table());
		shown.close();
		shown.readPictures();
		SwingUtilities.invokeAndWait(() -> assertNull(shown.getValueAt(0, BatchTable.PICTURE)));
	}

	@Test
	void whatAReviewChangedIsReadInTheBackgroundBeforeWhatFollows() throws Exception {
		final OutcomesTable shown = new OutcomesTable(table());
		Files.copy(out.resolve("drawn").resolve("overlay.png"),
			out.resolve("plain").resolve("overlay.png"));
		final CompletableFuture<Boolean> followed = new CompletableFuture<>();
		SwingUtilities.invokeAndWait(() -> shown.refresh(2,
			() -> followed.complete(SwingUtilities.isEventDispatchThread())));
		assertTrue(followed.get(60, TimeUnit.SECONDS));
		final Object[] picture = new Object[1];
		for (int i = 0; i < 1200 && picture[0] == null; i++) {
			Thread.sleep(50);
			SwingUtilities
				.invokeAndWait(() -> picture[0] = shown.getValueAt(2, BatchTable.PICTURE));
		}
		assertNotNull(picture[0]);
	}

	private static double ratio(final BufferedImage picture) {
		return (double) picture.getWidth() / picture.getHeight();
	}

	/** How many pixels of a row's cell have the picture's colour. */
	private static int coloured(final OutcomesTable table, final int row) {
		final Component cell = table.prepareRenderer(table.getCellRenderer(row, BatchTable.PICTURE),
			row, BatchTable.PICTURE);
		cell.setSize(new Dimension(85, table.getRowHeight()));
		final BufferedImage seen = new BufferedImage(85, table.getRowHeight(),
			BufferedImage.TYPE_INT_RGB);
		cell.paint(seen.createGraphics());
		int count = 0;
		for (int y = 0; y < seen.getHeight(); y++)
			for (int x = 0; x < seen.getWidth(); x++)
				if (seen.getRGB(x, y) == CONTOUR.getRGB())
					count++;
		return count;
	}

	@Test
	void aLongMessageIsWrappedAndToldInFull() throws Exception {
		final OutcomesTable shown = new OutcomesTable(new BatchTable(out,
			List.of(BatchOutcome.failed(row("drawn").row(), "<No> file & no frames."))));
		final int last = BatchTable.COLUMNS.size() - 1;
		final JLabel cell = (JLabel) shown.prepareRenderer(shown.getCellRenderer(0, last), 0, last);
		assertEquals("<html>&lt;No&gt; file &amp; no frames.", cell.getToolTipText());
		assertEquals(cell.getText(), cell.getToolTipText());
	}

	@Test
	void theReportOpensInTheBrowserAndAMissingOneIsSaid() throws Exception {
		final Path page = Files.writeString(out.resolve(BatchList.PAGE), "a page");
		final List<Path> opened = new ArrayList<>();
		final JPanel panel = new BatchWindow(table(), Optional.empty()).panel(opened::add);
		final JButton report = (JButton) find(panel, "HTML report").orElseThrow();
		assertTrue(report.isEnabled());
		report.doClick();
		assertEquals(List.of(page), opened);
		Files.delete(page);
		report.doClick();
		assertEquals(1, opened.size());
		assertTrue(status(panel).contains("is not in the folder any more"), status(panel));
	}

	@Test
	void withoutAPageThereIsNothingToOpenAndABrowserThatFailsIsSaid() throws Exception {
		final BatchTable table = table();
		assertFalse(find(new BatchWindow(table, Optional.empty()).panel(p -> {
		}), "HTML report").orElseThrow().isEnabled());
		Files.writeString(out.resolve(BatchList.PAGE), "a page");
		final JPanel panel = new BatchWindow(table, Optional.empty()).panel(p -> {
			throw new UserException("No browser.");
		});
		((JButton) find(panel, "HTML report").orElseThrow()).doClick();
		assertEquals("No browser.", status(panel));
	}

	private static String status(final JPanel panel) {
		return ((JLabel) find(panel, "status").orElseThrow()).getText();
	}

	private static Optional<Component> find(final Container in, final String name) {
		for (final Component part : in.getComponents()) {
			if (name.equals(part.getName()))
				return Optional.of(part);
			if (part instanceof Container inner && find(inner, name).isPresent())
				return find(inner, name);
		}
		return Optional.empty();
	}
}
