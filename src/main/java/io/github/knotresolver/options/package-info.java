/**
 * Every option of a run, once: {@link io.github.knotresolver.options.ResolveOptions} has its
 * key, default, range, unit and help. Command line, sheets, JSON and the documents' tables
 * follow from it; {@link io.github.knotresolver.options.RunOptions} turns texts into settings.
 */
package io.github.knotresolver.options;
