/**
 * The facade: {@link io.github.knotresolver.pipeline.FilamentResolver} walks a movie through the rooms
 * from image to track, as {@link io.github.knotresolver.pipeline.Parameters} say, and returns a
 * {@link io.github.knotresolver.pipeline.Resolution}.
 */
package io.github.knotresolver.pipeline;
