package io.github.knotresolver.io;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.model.UserException;

/**
 * {@code batch.csv} in the folder of a batch: one row for every row of the sheet
 * that has had its turn. It is written anew after each of them, and is complete at
 * any time. While it is open no other batch writes to the folder.
 */
public final class BatchList implements AutoCloseable {

	/** The list's name. */
	public static final String FILE = "batch.csv";

	private static final String[] HEADER = {"line", "movie", "status", "result", "message"};

	private final Path file;
	private final HiddenNames hidden;
	private final FolderLock lock;
	private final List<BatchOutcome> outcomes = new ArrayList<>();

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
		requireList(out, folder.resolve(FILE), inputs);
		try {
			Files.createDirectories(folder);
		} catch (final IOException e) {
			throw new UserException(
				"out " + out + " cannot be made; choose another folder in a writable place.", e);
		}
		final Path file = folder.toRealPath().resolve(FILE);
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

	private static void requireList(final Path out, final Path file, final Collection<Path> inputs)
		throws IOException {
		if (!Files.exists(file))
			return;
		for (final Path input : inputs)
			if (Files.exists(input) && Files.isSameFile(input, file))
				throw new UserException("out " + out + " holds " + FILE
					+ ", which is read and would be replaced by the list of results; choose another folder.");
		if (!isOurs(file))
			throw new UserException("out " + out + " holds a " + FILE
				+ " that is not a list of this program; move it away, or choose another folder.");
	}

	private static boolean isOurs(final Path file) {
		try (BufferedReader reader = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
			return String.join(",", HEADER).equals(reader.readLine());
		} catch (final IOException e) {
			return false;
		}
	}

	/**
	 * Adds a row.
	 *
	 * @param outcome what came of it
	 * @throws IOException if the list cannot be written
	 */
	public void add(final BatchOutcome outcome) throws IOException {
		outcomes.add(outcome);
		write();
	}

	private void write() throws IOException {
		final Path workplace = Files.createDirectory(hidden.fresh(HiddenNames.PARTIAL));
		try {
			final Path list = workplace.resolve(FILE);
			try (CSVPrinter csv = CsvFile.create(list, HEADER)) {
				for (final BatchOutcome o : outcomes)
					csv.printRecord(o.row().line(), o.row().movie(), o.label(),
						o.folder().orElse(""), o.message());
			}
			FileTrees.replace(list, file);
		} finally {
			FileTrees.delete(workplace);
		}
	}

	/** @return what came of the rows so far, in their order */
	public List<BatchOutcome> outcomes() {
		return List.copyOf(outcomes);
	}

	@Override
	public void close() throws IOException {
		lock.close();
	}
}
