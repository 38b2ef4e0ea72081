package io.github.knotresolver.command;

import net.imagej.patcher.LegacyInjector;

import ij.IJ;

/** Runs a macro without a display, as Fiji does: its file, and its argument. */
final class HeadlessMacroMain {

	static {
		LegacyInjector.preinit();
	}

	private HeadlessMacroMain() {
	}

	public static void main(final String[] args) {
		Macros.run(args[0], args.length > 1 ? args[1] : "");
		System.exit(0);
	}

	/** ImageJ's classes may be touched only after they were patched. */
	private static final class Macros {

		static void run(final String file, final String argument) {
			IJ.runMacroFile(file, argument);
		}
	}
}
