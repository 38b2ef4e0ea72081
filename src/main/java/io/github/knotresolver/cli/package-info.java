/**
 * The command line: reads options, calls the run, writes a result folder
 * and says in one line what came of it. Errors are one line on standard error,
 * never a stack trace; the exit status tells what kind
 * ({@link io.github.knotresolver.cli.ExitStatus}). No ImageJ window and no
 * SciJava context is started.
 */

package io.github.knotresolver.cli;
