/**
 * Results become files, and files become values again: the rooms' values on one
 * side, what a person or another program reads and writes on the other.
 * <p>
 * A result folder is complete or absent
 * ({@link io.github.knotresolver.io.ResultFolder}). Numbers are written with a
 * dot and lines end with a line feed, whatever the machine's locale. Nothing here
 * knows ImageJ.
 */

package io.github.knotresolver.io;
