package io.github.knotresolver.io;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.CellText;
import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.progress.Progress;

/**
 * {@code batch.csv} in the folder of a batch: one row for every row of the sheet
 * that has had its turn, in the sheet's order. It is written anew after each of them, and is complete
 * at any time. Beside it, at the end, {@code batch.html}, a page that shows the results. While the list
 * is open no other batch writes to the folder. For several threads.
 */
public final class BatchList implements AutoCloseable {

	/** The list's name. */
	public static final String FILE = "batch.csv";
	/** The page's name. */
	public static final String PAGE = "batch.html";
	/** The folder of lists of some of the rows. */
	public static final String PARTS = "batch-rows";
	/** What a page of this program has in its first lines. */
	public static final String PAGE_MARK = "<meta name=\"generator\" content=\""
		+ ProgramVersion.NAME + "\"";

	/** Writes a page. */
	@FunctionalInterface
	public interface Page {

		/**
		 * @param file the new file
		 * @throws IOException if it cannot be written
		 */
		void write(Path file) throws IOException;
	}

	private static final String[] HEADER = {"line", "movie", "status", "result", "message"};
	private static final int MARK_LINES = 10;
	private static final String CSV = ".csv";

	private final Path file;
	private final HiddenNames hidden;
	private final FolderLock lock;
	private final SortedMap<Integer, BatchOutcome> outcomes = new TreeMap<>();

	private BatchList(final Path file, final HiddenNames hidden, final FolderLock lock) {
		this.file = file;
		this.hidden = hidden;
		this.lock = lock;
	}

	/**
	 * Opens the list of a folder, and clears what killed runs left there.
	 *
	 * @param out the folder of the result folders; made if absent
	 * @param inputs files that are read; they are never replaced
	 * @return the list, to be closed
	 * @throws UserException if the folder cannot be used, in one sentence
	 * @throws IOException if files cannot be made in it
	 */
	public static BatchList open(final Path out, final Collection<Path> inputs) throws IOException {
		final Path folder = ResultPlace.of(out).target();
		for (final String name : List.of(FILE, PAGE))
			requireOurs(out, folder.resolve(name), inputs);
		make(out, folder);
		return open(out, folder, folder.toRealPath().resolve(FILE));
	}

	/**
	 * Opens a list of some of the rows, beside others: a file in the folder {@value #PARTS}.
	 *
	 * @param out the folder of the result folders; made if absent
	 * @param part its name, without ending
	 * @param inputs files that are read; they are never replaced
	 * @return the list, to be closed
	 * @throws UserException if the folder cannot be used, in one sentence
	 * @throws IOException if files cannot be made in it
	 */
	public static BatchList open(final Path out, final String part, final Collection<Path> inputs)
		throws IOException {
		final Path folder = ResultPlace.of(out).target();
		final Path parts = folder.resolve(PARTS);
		requireOurs(out, parts.resolve(part + CSV), inputs);
		make(out, parts);
		return open(out, folder, parts.toRealPath().resolve(part + CSV));
	}

	private static void make(final Path out, final Path folder) {
		try {
			Files.createDirectories(folder);
		} catch (final IOException e) {
			throw new UserException(
				"out " + out + " cannot be made; choose another folder in a writable place.", e);
		}
	}

	private static BatchList open(final Path out, final Path folder, final Path file)
		throws IOException {
		final HiddenNames hidden = HiddenNames.of(file.getParent(), file);
		final FolderLock lock = FolderLock.acquire(hidden.lock())
			.orElseThrow(() -> new UserException("out " + out
				+ " is being written by another batch; wait for it, or choose another folder."));
		try {
			Leftovers.clear(hidden, file);
			Leftovers.clearAll(folder);
			return new BatchList(file, hidden, lock);
		} catch (final IOException | RuntimeException e) {
			lock.close();
			throw e;
		}
	}

	/**
	 * What the lists of some of the rows tell.
	 *
	 * @param out the folder of the result folders
	 * @param rows the rows of the sheet
	 * @return what came of them, of those that are in a list; of several, what the last one tells
	 * @throws IOException if the folder cannot be read
	 */
	public static Map<BatchRow, BatchOutcome> told(final Path out, final List<BatchRow> rows)
		throws IOException {
		final Path parts = out.resolve(PARTS);
		final Map<BatchRow, BatchOutcome> told = new HashMap<>();
		if (!Files.isDirectory(parts))
			return told;
		for (final String name : FileTrees.names(parts)) {
			if (!name.endsWith(CSV) || !isOurs(parts.resolve(name)))
				continue;
			for (final CsvFile.Row line : CsvFile.read(parts.resolve(name)))
				rows.stream()
					.filter(r -> line.get(0).equals(Integer.toString(r.line()))
						&& line.get(1).equals(CellText.clean(r.shown())))
					.findFirst().ifPresent(r -> told.put(r, outcome(r, line)));
		}
		return told;
	}

	private static BatchOutcome outcome(final BatchRow row, final CsvFile.Row line) {
		return new BatchOutcome(row, Status.valueOf(line.get(2).toUpperCase(Locale.ROOT)),
			Optional.of(line.get(3)).filter(name -> !name.isEmpty()), line.get(4));
	}

	private static void requireOurs(final Path out, final Path file, final Collection<Path> inputs)
		throws IOException {
		if (!Files.exists(file))
			return;
		final String name = file.getFileName().toString();
		for (final Path input : inputs)
			if (Files.exists(input) && Files.isSameFile(input, file))
				throw new UserException("out " + out + " holds " + name
					+ ", which is read and would be replaced by the list of results; choose another folder.");
		if (!isOurs(file))
			throw new UserException("out " + out + " holds a " + name
				+ " that is not a list of this program; move it away, or choose another folder.");
	}

	private static boolean isOurs(final Path file) {
		try (BufferedReader reader = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
			return file.getFileName().toString().endsWith(CSV)
				? String.join(",", HEADER).equals(reader.readLine())
				: reader.lines().limit(MARK_LINES).anyMatch(line -> line.contains(PAGE_MARK));
		} catch (final IOException | UncheckedIOException e) {
			return false;
		}
	}

	/**
	 * Adds a row.
	 *
	 * @param index its place among the rows, from 0
	 * @param outcome what came of it
	 * @throws IOException if the list cannot be written
	 */
	public synchronized void add(final int index, final BatchOutcome outcome) throws IOException {
		note(index, outcome);
		write();
	}

	/**
	 * Adds a row, to be written later.
	 *
	 * @param index its place among the rows, from 0
	 * @param outcome what came of it
	 */
	public synchronized void note(final int index, final BatchOutcome outcome) {
		outcomes.put(index, outcome);
	}

	/** @throws IOException if the list cannot be written */
	public synchronized void write() throws IOException {
		// What is finished is told even if the user asked to stop meanwhile.
		Cancellation.during(Progress.NONE, () -> {
			replace(file.getFileName().toString(), this::list);
			return null;
		});
	}

	private void list(final Path target) throws IOException {
		try (CSVPrinter csv = CsvFile.create(target, HEADER)) {
			for (final BatchOutcome o : outcomes.values())
				csv.printRecord(o.row().line(), o.row().shown(), o.label(), o.folder().orElse(""),
					o.message());
		}
	}

	/**
	 * Replaces the page.
	 *
	 * @param page writes it
	 * @throws IOException if it cannot be written; the earlier one stays then
	 */
	public synchronized void page(final Page page) throws IOException {
		replace(PAGE, page);
	}

	private void replace(final String name, final Page content) throws IOException {
		final Path workplace = Files.createDirectory(hidden.fresh(HiddenNames.PARTIAL));
		try {
			content.write(workplace.resolve(name));
			FileTrees.replace(workplace.resolve(name), file.resolveSibling(name));
		} finally {
			FileTrees.delete(workplace);
		}
	}

	/** @return what came of the rows so far, in their order */
	public synchronized List<BatchOutcome> outcomes() {
		return List.copyOf(outcomes.values());
	}

	@Override
	public void close() throws IOException {
		lock.close();
	}
}
