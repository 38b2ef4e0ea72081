package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

import javax.swing.SwingUtilities;

import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;
import org.scijava.widget.FileWidget;

import ij.IJ;
import ij.macro.Interpreter;
import io.github.knotresolver.imagej.Batch;
import io.github.knotresolver.imagej.BatchWork;
import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.MacroOptions;
import io.github.knotresolver.io.BatchList;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.io.BatchSheet;
import io.github.knotresolver.io.MovieFolder;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;
import io.github.knotresolver.ui.BatchWindow;
import io.github.knotresolver.ui.model.BatchTable;

/**
 * {@code Batch...}: many movies, as many at a time as threads and memory allow, each into its own
 * result folder. Finished ones are skipped; one that fails is reported, and the rest go on.
 */
@Plugin(type = Command.class, label = "Batch...", attrs = @Attr(name = "no-legacy"))
public class BatchCommand extends KnotCommand {

	@Parameter(label = "Input (sheet or folder)", description = "A CSV with the columns FileName and FolderPath, or a folder of movies", required = false, persist = false)
	private File input;

	@Parameter(label = "Out (folder)", description = "Gets a result folder for every movie, batch.csv and batch.html", style = FileWidget.DIRECTORY_STYLE, required = false, persist = false)
	private File out;

	@Parameter(label = "Options", description = "For all movies, as Resolve Filament has them: threshold=0.4 channel=2", columns = 26, required = false, persist = false)
	private String options = "";

	@Parameter(label = "Movies at a time", description = "Most movies at a time; 0 for as many as threads and memory allow", min = "0", required = false, persist = false)
	private int movies = 0;

	@Parameter(label = "Plots in the folders", required = false, persist = false)
	private boolean plots = true;

	@Parameter(label = "Force (do finished movies again)", required = false, persist = false)
	private boolean force = false;

	private Engine engine = Engine.PIPELINE;

	/** @param other what resolves movies instead of a session */
	void setEngine(final Engine other) {
		engine = other;
	}

	@Override
	void work(final Progress progress) throws IOException {
		if (input == null || out == null)
			throw new UserException((input == null ? "input" : "out")
				+ " is missing; name a sheet or a folder of movies as input, and a folder for the results as out.");
		final Map<String, String> texts = new TreeMap<>();
		final Form resolve = Form.of(new ResolveFilamentCommand());
		MacroOptions.parse(options == null ? "" : options, name -> null).values()
			.forEach((key, value) -> texts.put(resolve.name(key), value.orElse("true")));
		RunOptions.parse(texts);
		final BatchSheet sheet = MovieFolder.read(input.toPath());
		if (!sheet.unknownColumns().isEmpty())
			say("Columns that mean nothing here: " + String.join(", ", sheet.unknownColumns())
				+ ".");
		final Optional<Integer> most = movies == 0 ? Optional.empty() : Optional.of(movies);
		final List<BatchOutcome> outcomes = new Batch(engine, texts, force, plots, most).run(
			new BatchWork(sheet.rows(), out.toPath(), List.of(input.toPath())), o -> say(o.line()),
			progress);
		final long failed = outcomes.stream().filter(o -> o.status() == Status.FAILED).count();
		if (!GraphicsEnvironment.isHeadless() && !Interpreter.isBatchMode() && !IJ.isMacro()) {
			final BatchTable table = new BatchTable(out.toPath(), outcomes);
			SwingUtilities.invokeLater(() -> BatchWindow.open(out.toPath(), table));
		}
		say((outcomes.size() - failed) + " of " + outcomes.size() + " movies have a result. List: "
			+ new File(out, BatchList.FILE) + ", page: " + new File(out, BatchList.PAGE));
	}
}
