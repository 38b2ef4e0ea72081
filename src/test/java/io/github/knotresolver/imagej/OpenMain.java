package io.github.knotresolver.imagej;

import java.nio.file.Path;

import io.github.knotresolver.model.UserException;

/** Opens a movie and prints how many frames came, or why none. */
public final class OpenMain {

	private OpenMain() {
	}

	public static void main(final String[] args) {
		try {
			System.out.println("frames: " + ImageFile.open(Path.of(args[0])).getStackSize());
		} catch (final UserException e) {
			System.out.println("refused: " + e.getMessage());
		}
	}
}
