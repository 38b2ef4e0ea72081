package io.github.knotresolver.model;

/** Whether the filament keeps its length. */
public enum LengthModel {
	/** The same in all frames, unless the movie says that it changes. */
	AUTO,
	/** The same in all frames. */
	CONSTANT,
	/** What each frame says. */
	FREE
}
