package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * The result folders of a batch: which of its rows are finished already, and
 * where the others go. A row is finished if a folder holds the result of the same
 * movie, by its path and contents, with the same options, by the same version;
 * the folder's name does not matter. A folder is never given to another movie
 * than the one whose result it holds.
 */
public final class BatchFolders {

	/**
	 * Where a row's result is, or goes.
	 *
	 * @param name the folder's name
	 * @param isFinished whether the result is there
	 */
	public record Place(String name, boolean isFinished) {
	}

	/**
	 * Some of the rows, one after another.
	 *
	 * @param first number of the first, from 1
	 * @param last number of the last
	 */
	public record Rows(int first, int last) {

		/** All rows of any sheet. */
		public static final Rows ALL = new Rows(1, Integer.MAX_VALUE);
		/** None. */
		public static final Rows NONE = new Rows(1, 0);

		private static final Pattern TEXT = Pattern.compile("([0-9]{1,9})(?:-([0-9]{1,9}))?");

		/**
		 * @param text such as 3 or 3-7
		 * @return the rows
		 * @throws UserException if it says something else, in one sentence
		 */
		public static Rows parse(final String text) {
			final Matcher told = TEXT.matcher(text.strip());
			if (told.matches()) {
				final int first = Integer.parseInt(told.group(1));
				final int last = told.group(2) == null ? first : Integer.parseInt(told.group(2));
				if (first >= 1 && last >= first)
					return new Rows(first, last);
			}
			throw new UserException(
				"rows must be a row's number from 1, or a first and a last one such as 3-7, but is '"
					+ text + "'.");
		}

		/**
		 * @param index of a row, from 0
		 * @return whether it is among them
		 */
		public boolean has(final int index) {
			return index >= first - 1 && index < last;
		}

		/** @return them as text, for names of files */
		public String label() {
			return first + "-" + last;
		}
	}

	private final Path out;
	private final Map<String, RunIdentity> present = new TreeMap<>();
	private final FolderNames names = new FolderNames(BatchList.FILE, BatchList.PAGE,
		BatchList.PARTS);
	private final Map<BatchRow, Place> finished = new HashMap<>();

	private BatchFolders(final Path out) {
		this.out = out;
	}

	/**
	 * Looks which rows are finished. The contents of a movie are read only if it has its turn, and
	 * there is a result of its file.
	 *
	 * @param out the existing folder of the result folders
	 * @param rows the rows
	 * @param defaults options of all rows, by key; a row's own go over them
	 * @param turn the rows that have their turn; of the others it is enough that their result has the
	 *          same path and options
	 * @param progress may cancel
	 * @return the folders
	 * @throws IOException if the folder cannot be read
	 */
	public static BatchFolders of(final Path out, final List<BatchRow> rows,
		final Map<String, String> defaults, final Rows turn, final Progress progress)
		throws IOException {
		final BatchFolders folders = new BatchFolders(out);
		try (Stream<Path> inside = Files.list(out)) {
			for (final Path folder : inside.filter(Files::isDirectory).sorted().toList())
				RunIdentity.read(folder)
					.ifPresent(i -> folders.present.put(folder.getFileName().toString(), i));
		}
		for (int i = 0; i < rows.size(); i++)
			folders.find(rows.get(i), rows.get(i).over(defaults), turn.has(i), progress);
		return folders;
	}

	private void find(final BatchRow row, final Map<String, String> texts, final boolean exactly,
		final Progress progress) {
		try {
			final Path movie = row.file().toAbsolutePath().normalize();
			final List<String> candidates = new ArrayList<>(present.keySet());
			candidates.removeIf(n -> !present.get(n).movie().equals(movie));
			finished.values().forEach(p -> candidates.remove(p.name()));
			if (candidates.isEmpty())
				return;
			final Predicate<RunIdentity> isSame;
			if (exactly) {
				final RunIdentity identity = RunIdentity.of(movie, texts, progress);
				isSame = i -> i.isSame(identity);
			} else
				isSame = i -> i.isOf(movie, texts);
			candidates.stream().filter(n -> isSame.test(present.get(n))).findFirst()
				.ifPresent(n -> {
					names.take(n);
					finished.put(row, new Place(n, true));
				});
		} catch (final IOException | UserException e) {
			// The row fails for the same reason when it has its turn.
		}
	}

	/**
	 * @param row a row that has its turn
	 * @return where its result is, or goes
	 * @throws UserException if the movie's name cannot be used, in one
	 *           sentence
	 */
	public Place place(final BatchRow row) {
		final Place place = finished.get(row);
		if (place != null)
			return place;
		final Path movie = row.file().toAbsolutePath().normalize();
		return new Place(names.next(row.name(), n -> isFree(n, movie)), false);
	}

	private boolean isFree(final String name, final Path movie) {
		final Path folder = out.resolve(name);
		if (!Files.exists(folder))
			return true;
		return Optional.ofNullable(present.get(name)).map(i -> i.movie().equals(movie))
			.orElse(false);
	}
}
