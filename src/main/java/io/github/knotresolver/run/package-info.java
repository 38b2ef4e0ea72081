/**
 * The use case, once: a movie is read from a source, resolved, measured, and written to a sink
 * ({@link io.github.knotresolver.run.ResolveRun}). What a source or a sink is, images and folders or
 * windows, the rooms below decide; command line, Commands and batches all call this.
 */
package io.github.knotresolver.run;
