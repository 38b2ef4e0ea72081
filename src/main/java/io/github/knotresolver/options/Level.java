package io.github.knotresolver.options;

/** Who meets an option. */
public enum Level {
	/** Everyone: what a person knows about the movie. */
	BASIC,
	/** Those who look deeper: how the method goes about it. */
	ADVANCED
}
