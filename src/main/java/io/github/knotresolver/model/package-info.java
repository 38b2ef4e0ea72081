/**
 * What every room talks about, said once: a movie, how it is to be resolved, and the
 * filaments that were found in it.
 */
package io.github.knotresolver.model;
