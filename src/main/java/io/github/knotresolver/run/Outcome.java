package io.github.knotresolver.run;

import java.util.Optional;

import io.github.knotresolver.io.MeasuredTracks;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.options.InputOptions;

/**
 * What came of a run.
 *
 * @param result the result, measured
 * @param input how the movie was taken from its image
 * @param identity what it was made from; empty if the movie has no file
 */
public record Outcome(MeasuredTracks result, InputOptions input, Optional<RunIdentity> identity) {
}
