package io.github.knotresolver.fuzz;

import net.jqwik.api.lifecycle.AfterContainer;
import net.jqwik.api.lifecycle.BeforeContainer;

/** A test that writes what it draws into a folder of its own, and is judged at the end. */
public abstract class Fuzzing {

	/** Where drawn files go; one test runs at a time. */
	protected static Scratch folder;

	/** Makes the folder before the first input. */
	@BeforeContainer
	static void makeFolder() {
		folder = new Scratch();
	}

	/** Deletes it after the last input, and fails if anything failed. */
	@AfterContainer
	static void judge() {
		folder.delete();
		Guard.assertNone();
	}
}
