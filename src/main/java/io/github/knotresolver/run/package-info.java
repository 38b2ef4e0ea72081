/**
 * The use cases, each once. A movie is read from a source, resolved, measured, and written to a sink
 * ({@link io.github.knotresolver.run.ResolveRun}); contours are measured
 * ({@link io.github.knotresolver.run.MeasureRun}) or scored
 * ({@link io.github.knotresolver.run.Scores}), movies simulated
 * ({@link io.github.knotresolver.run.SimulationRun}) or made like a user's
 * ({@link io.github.knotresolver.run.LikeRun}). What a source or a sink is, images and folders or
 * windows, the rooms below decide; command line, Commands and batches all call this.
 */
package io.github.knotresolver.run;
