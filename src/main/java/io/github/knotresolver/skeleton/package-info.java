/**
 * A mask becomes a line one pixel wide, with its branch and end pixels. The
 * line has as many parts and as many holes as the mask, and lies in its middle.
 */

package io.github.knotresolver.skeleton;
