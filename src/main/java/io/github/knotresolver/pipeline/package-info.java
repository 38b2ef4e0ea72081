/**
 * The facade: {@link io.github.knotresolver.pipeline.FilamentResolver} walks a movie through the rooms
 * from image to track, as {@link io.github.knotresolver.model.Settings} say, and returns a
 * {@link io.github.knotresolver.model.Tracks}.
 */
package io.github.knotresolver.pipeline;
