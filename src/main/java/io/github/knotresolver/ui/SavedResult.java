package io.github.knotresolver.ui;

import java.awt.Component;
import java.io.File;
import java.io.IOException;
import java.util.function.Consumer;

import javax.swing.JFileChooser;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileFilter;

import io.github.knotresolver.io.Failure;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** Writes a reviewed result while its window goes on. */
final class SavedResult {

	private SavedResult() {
	}

	/**
	 * @param result what is written
	 * @param say told, in the thread of events, what is done and what came of it
	 * @param done called at the end in that thread, whatever came of it
	 */
	static void inBackground(final ReviewedResult result, final Consumer<String> say,
		final Runnable done) {
		say.accept("Saving ...");
		final Thread thread = new Thread(() -> {
			final String outcome = save(result,
				stage -> SwingUtilities.invokeLater(() -> say.accept("Saving: " + stage + " ...")));
			SwingUtilities.invokeLater(() -> {
				done.run();
				say.accept(outcome);
			});
		}, "KnotResolver save");
		thread.start();
	}

	/**
	 * Asks for the folder of a result that was never written.
	 *
	 * @return whether one was chosen
	 * @throws UserException if it cannot be used, in one sentence
	 */
	static boolean chooseFolder(final ReviewedResult result, final Component parent) {
		final JFileChooser chooser = new JFileChooser();
		chooser.setDialogTitle("A new folder for the result");
		// Where only folders can be chosen, Swing does not show the name of a new one.
		chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
		chooser.setAcceptAllFileFilterUsed(false);
		chooser.setFileFilter(new Folders());
		chooser
			.setSelectedFile(result.file()
				.map(f -> f
					.resolveSibling(
						f.getFileName().toString().replaceFirst("[.][^.]*$", "") + "-result")
					.toFile())
				.orElse(new File(result.name() + "-result")));
		if (chooser.showSaveDialog(parent) != JFileChooser.APPROVE_OPTION)
			return false;
		result.chooseFolder(chooser.getSelectedFile().toPath());
		return true;
	}

	private static String save(final ReviewedResult result, final Consumer<String> stages) {
		try {
			result.save(new Progress() {

				@Override
				public void report(final String stage, final double fraction) {
					if (fraction == 0)
						stages.accept(stage);
				}

				@Override
				public boolean isCancelled() {
					return false;
				}
			});
			return "Saved in " + result.folder().orElseThrow() + ".";
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
			return "Nothing was saved.";
		} catch (final IOException | RuntimeException | Error e) {
			return Failure.of(e, "give Java more memory").sentence();
		}
	}

	/** Files are not shown. */
	private static final class Folders extends FileFilter {

		@Override
		public boolean accept(final File file) {
			return file.isDirectory();
		}

		@Override
		public String getDescription() {
			return "Folders";
		}
	}
}
