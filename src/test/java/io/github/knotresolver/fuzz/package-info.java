/**
 * Inputs as nobody would make them on purpose: drawn by jqwik, in part valid, in part damaged.
 * Whatever is read, it is understood or refused in one sentence for people; nothing else may
 * happen, and nothing may take for ever. {@code scripts/fuzz} draws many more than the build.
 */
package io.github.knotresolver.fuzz;
