package io.github.knotresolver.cli;

import java.io.IOException;

import io.github.knotresolver.model.UserException;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Input that cannot be used is wrong usage, which has an exit status of its own. */
final class Usage {

	/** Reads input, or checks it. */
	@FunctionalInterface
	interface Reading<T> {

		T get() throws IOException;
	}

	private Usage() {
	}

	/**
	 * @param spec the subcommand
	 * @param reading reads what the user gave
	 * @return what was read
	 * @throws ParameterException if it cannot be used
	 * @throws IOException if files cannot be made
	 */
	static <T> T of(final CommandSpec spec, final Reading<T> reading) throws IOException {
		try {
			return reading.get();
		} catch (final UserException e) {
			throw new ParameterException(spec.commandLine(), e.getMessage(), e);
		}
	}
}
