package io.github.knotresolver.run;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.options.InputOptions;

/**
 * What came of a run.
 *
 * @param result the result, measured
 * @param input how the movie was taken from its image
 * @param identity what it was made from; empty if the movie has no file
 * @param leftOut what the sink left out and why, a sentence or two each
 */
public record FinishedRun(MeasuredTracks result, InputOptions input, Optional<RunIdentity> identity,
	List<String> leftOut) {

	public FinishedRun {
		leftOut = List.copyOf(leftOut);
	}

	/** @return what a person should read: the result in a few lines, and what was left out */
	public List<String> report() {
		return Stream.concat(RunReport.lines(result).stream(), leftOut.stream()).toList();
	}
}
