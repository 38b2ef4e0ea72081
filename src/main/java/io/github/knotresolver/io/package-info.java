/**
 * Results become files, and text becomes options: the rooms' values on one
 * side, what a person or another program reads and writes on the other.
 * <p>
 * A result folder is complete or absent
 * ({@link io.github.knotresolver.io.ResultFolder}). Numbers are written with a
 * dot and lines end with a line feed, whatever the machine's locale. The names
 * of options are defined once ({@link io.github.knotresolver.options.RunOptions})
 * for the command line, macros and batch sheets. Nothing here knows ImageJ.
 */

package io.github.knotresolver.io;
