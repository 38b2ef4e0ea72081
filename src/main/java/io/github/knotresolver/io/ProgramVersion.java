
package io.github.knotresolver.io;

import java.util.Optional;

/** Which version of the program this is. */
public final class ProgramVersion {

	/** The program's name, as files state it. */
	public static final String NAME = "KnotResolver";

	private ProgramVersion() {
	}

	/**
	 * @return the version of the jar; {@code development} when the classes do not
	 *         come from a jar
	 */
	public static String get() {
		return Optional.ofNullable(ProgramVersion.class.getPackage().getImplementationVersion())
			.orElse("development");
	}
}
