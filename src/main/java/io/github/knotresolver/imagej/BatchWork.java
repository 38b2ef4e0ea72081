package io.github.knotresolver.imagej;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.model.UserException;

/**
 * What a batch works on.
 *
 * @param rows the rows of a sheet, in their order
 * @param out the folder of the result folders; made if absent
 * @param inputs what else is read, such as the sheet
 */
public record BatchWork(List<BatchRow> rows, Path out, List<Path> inputs) {

	public BatchWork {
		rows = List.copyOf(rows);
		inputs = List.copyOf(inputs);
	}

	/**
	 * @param defaults options of all rows, by key; a row's own go over them
	 * @return all files that are read, of all rows; none of them is ever replaced
	 */
	List<Path> files(final Map<String, String> defaults) {
		final List<Path> read = new ArrayList<>(inputs);
		for (final BatchRow row : rows)
			try {
				read.addAll(RunIdentity.files(Optional.of(row.file()), row.over(defaults)));
			} catch (final UserException e) {
				// The row is refused when it has its turn.
			}
		return read;
	}

	/**
	 * What a row takes, for whoever gives jobs to machines.
	 *
	 * @param row its number, from 1
	 * @param movie the movie's file, as text
	 * @param megabytes of memory, rather too many than too few
	 */
	public record Plan(int row, String movie, long megabytes) {
	}

	/** @return what each row takes, told from its file, without reading the pixels */
	public List<Plan> plan() {
		final List<Plan> plan = new ArrayList<>();
		for (final BatchRow row : rows)
			plan.add(new Plan(plan.size() + 1, row.movie(), 1 + (MovieMemory.of(row) >> 20)));
		return plan;
	}
}
