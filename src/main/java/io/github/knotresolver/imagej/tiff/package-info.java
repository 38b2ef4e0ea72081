/**
 * TIFF files before ImageJ or a library sees them: what their directories promise,
 * whether it is there, which of its kinds it is, and what its metadata say about
 * axes and units.
 */

package io.github.knotresolver.imagej.tiff;
