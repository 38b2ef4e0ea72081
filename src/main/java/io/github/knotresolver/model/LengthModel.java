package io.github.knotresolver.model;

/** Whether the filament keeps its length. */
public enum LengthModel {
	/** The same in all frames. */
	CONSTANT,
	/** Growing or shrinking. */
	FREE
}
