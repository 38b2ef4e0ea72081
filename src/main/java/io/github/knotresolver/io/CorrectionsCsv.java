package io.github.knotresolver.io;

import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.options.RunOptions;

/** Corrections that a person drew, as a file has them. */
public final class CorrectionsCsv {

	private CorrectionsCsv() {
	}

	/**
	 * @param options the options of a run
	 * @return the contours in the file that they name, by 1-based frame; none if they
	 *         name no file
	 * @throws io.github.knotresolver.model.UserException if the file cannot be read as
	 *           corrections, in one sentence
	 */
	public static Map<Integer, Polyline> of(final RunOptions options) {
		final Optional<SortedMap<Integer, Polyline>> given = options.corrections()
			.map(ContoursCsv::read);
		return given.orElseGet(TreeMap::new);
	}
}
