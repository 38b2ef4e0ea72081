package io.github.knotresolver.options;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;

import io.github.knotresolver.model.Cleaning;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.UserException;

/** The options of a run while they are read, one after the other. */
final class Draft {

	final Settings.Builder settings = Settings.DEFAULT.edit();
	Segmentation segmentation = Segmentation.DEFAULT;
	OptionalInt logSize = OptionalInt.empty();
	OptionalDouble logSigma = OptionalDouble.empty();
	/** In the movie's unit of length, which is known only with the movie. */
	OptionalDouble length = OptionalDouble.empty();
	Optional<Path> corrections = Optional.empty();
	int channel = InputOptions.DEFAULT.channel();
	boolean zAsTime = InputOptions.DEFAULT.zAsTime();
	OptionalDouble pixelSize = OptionalDouble.empty();
	OptionalDouble frameInterval = OptionalDouble.empty();
	Optional<String> unit = Optional.empty();

	Settings settings() {
		return settings.segmentation(segmentation).cleaning(cleaning()).build();
	}

	InputOptions input() {
		return new InputOptions(channel, zAsTime, pixelSize, frameInterval, unit);
	}

	private Cleaning cleaning() {
		if (logSize.isPresent() != logSigma.isPresent())
			throw new UserException("log_size and log_sigma go together, but only "
				+ (logSize.isPresent() ? "log_size" : "log_sigma") + " was given.");
		return logSize.isPresent()
			? new Cleaning(logSize.getAsInt(), logSigma.getAsDouble())
			: Cleaning.DEFAULT;
	}
}
