/**
 * Progress, cancelling and threads: the foundation of long work. ImageJ, the command line and tests
 * are listeners of the same kind.
 */
package io.github.knotresolver.progress;
