/**
 * Movies with known truth: Brownian dynamics of a clamped semiflexible filament
 * over motor proteins, and its pictures as the published evaluation draws them
 * or as a microscope would. A side room: no movie needs it to be resolved.
 * <p>
 * Units inside are micrometres, piconewtons and seconds; pixels begin where a
 * picture is drawn. A seed gives the same movie on any machine: the random
 * numbers are integer arithmetic, the mathematics is {@link StrictMath}, and
 * one simulation runs in one thread.
 */

package io.github.knotresolver.simulate;
