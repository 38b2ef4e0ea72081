/**
 * How good a result is where the truth is known: overlap, distances and lengths
 * per frame, their summary over a movie, and the distribution of position
 * errors. A side room: no movie needs it to be resolved.
 */
package io.github.knotresolver.evaluate;
