/**
 * A polyline becomes a physical filament: an inextensible elastic curve whose
 * picture, drawn with the movie's own line model, is fitted to a frame.
 * <p>
 * {@link io.github.knotresolver.fit.Chain} is the curve,
 * {@link io.github.knotresolver.fit.LineModel} says what a line looks like,
 * {@link io.github.knotresolver.fit.ImageTerm} compares the two with a frame,
 * and {@link io.github.knotresolver.fit.FilamentFitter} moves the curve until
 * they agree.
 */

package io.github.knotresolver.fit;
