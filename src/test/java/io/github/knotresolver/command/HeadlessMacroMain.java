package io.github.knotresolver.command;

import net.imagej.patcher.LegacyInjector;

import ij.IJ;

/** Runs macro files without a display, as Fiji does: the file's name is the argument. */
final class HeadlessMacroMain {

	static {
		LegacyInjector.preinit();
	}

	private HeadlessMacroMain() {
	}

	public static void main(final String[] args) {
		for (final String macro : args)
			Macros.run(macro);
		System.exit(0);
	}

	/** ImageJ's classes may be touched only after they were patched. */
	private static final class Macros {

		static void run(final String file) {
			IJ.runMacroFile(file, null);
		}
	}
}
