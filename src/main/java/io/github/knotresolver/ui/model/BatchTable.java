package io.github.knotresolver.ui.model;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;

import io.github.knotresolver.io.BatchList;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.io.ResultCounts;

/**
 * What came of a batch, movie by movie, and which results a person should look at: those whose row of
 * the sheet asks for work by hand, then those with doubtful or lost frames.
 */
public final class BatchTable {

	/** What the columns of the table are called. */
	public static final List<String> COLUMNS = List.of("Movie", "State", "By hand", "Right",
		"Doubtful", "Lost", "Filaments", "Length", "Contours", "Message");

	/** Which of the columns has a picture. */
	public static final int PICTURE = COLUMNS.indexOf("Contours");

	/** Which of them is a length with its unit. */
	public static final int LENGTH = COLUMNS.indexOf("Length");

	private static final String OVERLAY = "overlay.png";

	private static final int BY_HAND = 2;

	private final Path out;
	private final List<BatchOutcome> outcomes;
	private final List<Optional<ResultCounts>> counts = new CopyOnWriteArrayList<>();

	/**
	 * @param out the folder of the result folders
	 * @param outcomes what came of the rows, in their order
	 */
	public BatchTable(final Path out, final List<BatchOutcome> outcomes) {
		this.out = out;
		this.outcomes = List.copyOf(outcomes);
		for (int row = 0; row < outcomes.size(); row++) {
			counts.add(Optional.empty());
			refresh(row);
		}
	}

	/**
	 * Reads the numbers of a result anew, by any thread.
	 *
	 * @param row of the table, from 0
	 */
	public void refresh(final int row) {
		counts.set(row, folder(row).flatMap(ResultCounts::read));
	}

	/** @return how many rows there are */
	public int size() {
		return outcomes.size();
	}

	/**
	 * @param row from 0
	 * @return the result folder; empty if the row failed
	 */
	public Optional<Path> folder(final int row) {
		return outcomes.get(row).folder().map(out::resolve);
	}

	/**
	 * @param row from 0
	 * @return the picture of all its contours; empty if there is none, such as of a run without plots
	 */
	public Optional<Path> picture(final int row) {
		return folder(row).map(f -> f.resolve(OVERLAY)).filter(Files::isRegularFile);
	}

	/** @return the page that shows all results; empty if there is none */
	public Optional<Path> page() {
		return Optional.of(out.resolve(BatchList.PAGE)).filter(Files::isRegularFile);
	}

	/**
	 * @param row from 0
	 * @param column from 0, of {@link #COLUMNS}
	 * @return what stands there: a text, or a whole number; empty text if it is not known, or a
	 *         picture
	 */
	public Object cell(final int row, final int column) {
		final BatchOutcome o = outcomes.get(row);
		return switch (COLUMNS.get(column)) {
			case "Movie" -> o.row().name();
			case "State" -> o.label();
			case "By hand" -> o.row().byHand() ? "asked for" : "";
			case "Right" -> count(row, ResultCounts::resolved);
			case "Doubtful" -> count(row, ResultCounts::doubtful);
			case "Lost" -> count(row, ResultCounts::lost);
			case "Filaments" -> count(row, ResultCounts::filaments);
			case "Length" -> count(row, ResultCounts::length);
			case "Contours" -> "";
			default -> o.message().startsWith(o.row().name() + ": ")
				? o.message().substring(o.row().name().length() + 2)
				: o.message();
		};
	}

	/**
	 * @param column from 0
	 * @return whether there are whole numbers in it
	 */
	public static boolean isNumber(final int column) {
		return List.of("Right", "Doubtful", "Lost", "Filaments").contains(COLUMNS.get(column));
	}

	private Object count(final int row, final Function<ResultCounts, Object> number) {
		return counts.get(row).map(number).orElse("");
	}

	/** @return whether any row asks for work by hand */
	public boolean isAnyByHand() {
		for (int row = 0; row < size(); row++)
			if (!cell(row, BY_HAND).equals(""))
				return true;
		return false;
	}

	/**
	 * @param after a row, from 0; -1 to begin
	 * @return the next row below it that a person should look at: of a sheet that asks for work by
	 *         hand anywhere, those that do; else those with doubtful or lost frames; empty if there is
	 *         none
	 */
	public OptionalInt next(final int after) {
		final boolean byHand = isAnyByHand();
		for (int row = after + 1; row < size(); row++)
			if (isToBeSeen(row, byHand))
				return OptionalInt.of(row);
		return OptionalInt.empty();
	}

	private boolean isToBeSeen(final int row, final boolean byHand) {
		if (outcomes.get(row).status() == Status.FAILED)
			return false;
		return byHand
			? outcomes.get(row).row().byHand()
			: counts.get(row).filter(c -> c.doubtful() + c.lost() > 0).isPresent();
	}

	/** @return what came of all of it, in one line */
	public String summary() {
		final long failed = outcomes.stream().filter(o -> o.status() == Status.FAILED).count();
		final int doubtful = counts.stream().flatMap(Optional::stream)
			.mapToInt(c -> c.doubtful() + c.lost()).sum();
		return size() - failed + " of " + size() + " movies have a result, with " + doubtful
			+ " frames to look at."
			+ (failed > 0 ? " Why others failed is in the last column." : "");
	}
}
