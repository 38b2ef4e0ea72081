/**
 * A movie that can be asked: {@link io.github.knotresolver.session.Session} walks it through the
 * rooms from image to track, as {@link io.github.knotresolver.model.Settings} say, keeps what it
 * found, and returns {@link io.github.knotresolver.model.Tracks}; and again after one more
 * {@link io.github.knotresolver.model.Constraint}.
 */
package io.github.knotresolver.session;
