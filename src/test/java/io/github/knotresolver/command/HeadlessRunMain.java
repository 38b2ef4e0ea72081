package io.github.knotresolver.command;

import org.scijava.SciJava;

/** Runs a Command as Fiji does with {@code --headless --run}. */
final class HeadlessRunMain {

	private HeadlessRunMain() {
	}

	public static void main(final String[] args) {
		new SciJava().launch(args);
		System.exit(0);
	}
}
