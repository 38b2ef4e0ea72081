package io.github.knotresolver.options;

import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Settings;

/**
 * What the values of a run's options are read from.
 *
 * @param settings what decided the result
 * @param input how the movie was taken from its image
 * @param calibration units of the movie
 */
record ChosenOptions(Settings settings, InputOptions input, Calibration calibration) {
}
