package io.github.knotresolver.options;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeMap;

import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Cleaning;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.session.FrameChoice;

/**
 * The options of a run, read from text: one definition ({@link ResolveOptions}) for
 * the command line ({@code --contraction-bias 0.4}), macros
 * ({@code contraction_bias=0.4}) and batch sheets (a column
 * {@code contraction_bias}). An option that is absent or blank has its default.
 * All values are checked here.
 */
public final class RunOptions {

	/** Every key, in the order in which a person thinks of them. */
	public static final Set<String> KEYS = ResolveOptions.KEYS;

	private final InputOptions input;
	private final Settings settings;
	private final OptionalDouble length;
	private final Optional<Path> corrections;

	private RunOptions(final Draft draft) {
		input = draft.input();
		settings = draft.settings();
		length = draft.length;
		corrections = draft.corrections;
	}

	/**
	 * Reads options.
	 *
	 * @param texts what was typed, by key
	 * @return the options
	 * @throws UserException if a key is not known or a value is not
	 *           allowed; one sentence that names the key, the value and what was
	 *           expected
	 */
	public static RunOptions parse(final Map<String, String> texts) {
		final TreeMap<String, String> given = new TreeMap<>(texts);
		given.keySet().stream().filter(key -> !KEYS.contains(key)).findFirst().ifPresent(key -> {
			throw new UserException("There is no option '" + key + "'; the options are "
				+ String.join(", ", KEYS) + ".");
		});
		given.values().removeIf(text -> text == null || text.isBlank());
		final Draft draft = new Draft();
		for (final Option option : ResolveOptions.ALL)
			if (given.containsKey(option.key()))
				option.read(draft, given.get(option.key()));
		return new RunOptions(draft);
	}

	/**
	 * The options of a run as they are written: what {@link #parse} reads back.
	 *
	 * @param settings what decided the result
	 * @param input how the movie was taken from its image
	 * @param calibration units of the movie
	 * @return the values by key, in the order of {@link ResolveOptions}; null where
	 *         nothing was told; without those that do not change the result, and without
	 *         corrections
	 */
	public static Map<String, Object> values(final Settings settings, final InputOptions input,
		final Calibration calibration) {
		final Chosen chosen = new Chosen(settings, input, calibration);
		final Map<String, Object> values = new LinkedHashMap<>();
		for (final Option option : ResolveOptions.ALL)
			if (option.isWritten())
				values.put(option.key(), option.value(chosen));
		return values;
	}

	/** @return how the movie is taken from its file */
	public InputOptions input() {
		return input;
	}

	/** @return the file of contours that the user gave; empty if there is none */
	public Optional<Path> corrections() {
		return corrections;
	}

	/**
	 * The settings for a movie: the known length in its pixels, and what can be
	 * checked only against the movie.
	 *
	 * @param movie the movie
	 * @param given what the user said about frames, in pixels: what {@link #corrections()}
	 *          holds
	 * @return the settings
	 * @throws UserException if they name a place, a frame or a
	 *           length that the movie does not have, or leave no frame
	 */
	public Settings settings(final Movie movie, final List<Constraint> given) {
		final OptionalDouble pixels = length.isPresent()
			? OptionalDouble.of(length.getAsDouble() / movie.calibration().pixelSize())
			: OptionalDouble.empty();
		final Settings fitting = settings.edit().length(pixels).constraints(given).build();
		new FrameChoice(movie, fitting).frames();
		fitting.region().ifPresent(r -> r.inside(movie).of(fitting));
		return fitting;
	}

	/**
	 * The settings for a movie without corrections.
	 *
	 * @param movie the movie
	 * @return the settings
	 * @throws UserException likewise
	 * @throws IllegalStateException if there is a file of corrections, which must be read
	 *           before
	 */
	public Settings parameters(final Movie movie) {
		if (corrections.isPresent())
			throw new IllegalStateException(
				"The corrections in " + corrections.get() + " have not been read.");
		return settings(movie, List.of());
	}

	/** @return whether the same was chosen, however it was written */
	@Override
	public boolean equals(final Object other) {
		return other instanceof RunOptions o && input.equals(o.input) && settings.equals(o.settings)
			&& length.equals(o.length) && corrections.equals(o.corrections);
	}

	@Override
	public int hashCode() {
		return Objects.hash(input, settings, length, corrections);
	}

	/**
	 * What the values of a run's options are read from.
	 *
	 * @param settings what decided the result
	 * @param input how the movie was taken from its image
	 * @param calibration units of the movie
	 */
	record Chosen(Settings settings, InputOptions input, Calibration calibration) {
	}

	/** The options of a run while they are read, one after the other. */
	static final class Draft {

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
}
