
package io.github.knotresolver.io;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.CandidateMethod;
import io.github.knotresolver.model.Cleaning;
import io.github.knotresolver.model.LengthModel;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.ResolverMethod;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.pipeline.FrameChoice;

/**
 * The options of a run, read from text: one definition for the command line
 * ({@code --contraction-bias 0.4}), macros ({@code contraction_bias=0.4}) and
 * batch sheets (a column {@code contraction_bias}). An option that is absent or
 * blank has its default. All values are checked here.
 */
public final class RunOptions {

	/** Every key, in the order in which a person thinks of them. */
	public static final Set<String> KEYS = keys("fixed_end", "region", "threshold", "iterations",
		"contraction_bias", "smooth_factor", "segmentation", "log_size", "log_sigma", "candidates",
		"resolver", "length", "length_model", "refine", "channel", "z_as_time", "frames",
		"ignore_frames", "corrections", "pixel_size", "frame_interval", "unit", "threads");

	private final InputOptions input;
	private final Settings parameters;
	private final OptionalDouble length;

	private RunOptions(final InputOptions input, final Settings parameters,
		final OptionalDouble length) {
		this.input = input;
		this.parameters = parameters;
		this.length = length;
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
		return new RunOptions(input(given), parameters(given), number(given, "length"));
	}

	/** @return how the movie is taken from its file */
	public InputOptions input() {
		return input;
	}

	/**
	 * The parameters for a movie: the known length in its pixels, and what can be
	 * checked only against the movie.
	 *
	 * @param movie the movie
	 * @return the parameters
	 * @throws UserException if they name a place, a frame or a
	 *           length that the movie does not have, or leave no frame
	 */
	public Settings parameters(final Movie movie) {
		final Settings p = parameters;
		final OptionalDouble pixels = length.isPresent()
			? OptionalDouble.of(length.getAsDouble() / movie.calibration().pixelSize())
			: OptionalDouble.empty();
		final Settings fitting = p.edit().length(pixels).build();
		new FrameChoice(movie, fitting).frames();
		p.region().ifPresent(r -> r.inside(movie).of(fitting));
		return fitting;
	}

	private static InputOptions input(final Map<String, String> given) {
		final String channel = given.getOrDefault("channel", "1");
		return new InputOptions(OptionText.wholeNumber("channel", channel, 1),
			flag(given, "z_as_time", false), number(given, "pixel_size"),
			number(given, "frame_interval"),
			Optional.ofNullable(given.get("unit")).map(UnitText::length));
	}

	private static Settings parameters(final Map<String, String> given) {
		final Settings d = Settings.DEFAULT;
		final Optional<Point> fixedEnd = Optional.ofNullable(given.get("fixed_end"))
			.map(t -> OptionText.point("fixed_end", t));
		return d.edit().fixedEnd(fixedEnd)
			.region(Optional.ofNullable(given.get("region"))
				.map(t -> OptionText.region("region", t)))
			.cleaning(cleaning(given)).segmentation(segmentation(given))
			.candidates(choice(given, "candidates", CandidateMethod.class, d.candidates()))
			.resolver(choice(given, "resolver", ResolverMethod.class, d.resolver()))
			.lengthModel(choice(given, "length_model", LengthModel.class, d.lengthModel()))
			.refine(flag(given, "refine", d.refine())).frames(frames(given, "frames"))
			.ignoreFrames(frames(given, "ignore_frames")).corrections(corrections(given))
			.threads(threads(given, d)).build();
	}

	private static Cleaning cleaning(final Map<String, String> given) {
		if (given.containsKey("log_size") != given.containsKey("log_sigma"))
			throw new UserException("log_size and log_sigma go together, but only "
				+ (given.containsKey("log_size") ? "log_size" : "log_sigma") + " was given.");
		if (!given.containsKey("log_size"))
			return Cleaning.DEFAULT;
		return new Cleaning(OptionText.wholeNumber("log_size", given.get("log_size")),
			OptionText.number("log_sigma", given.get("log_sigma")));
	}

	private static Segmentation segmentation(final Map<String, String> given) {
		final Segmentation d = Segmentation.DEFAULT;
		return new Segmentation(choice(given, "segmentation", Segmentation.Steps.class, d.steps()),
			OptionText.threshold(given.getOrDefault("threshold", "otsu")),
			OptionText.wholeNumber("iterations",
				given.getOrDefault("iterations", "" + d.iterations())),
			OptionText.number("contraction_bias",
				given.getOrDefault("contraction_bias", "" + d.contractionBias())),
			OptionText.number("smooth_factor",
				given.getOrDefault("smooth_factor", "" + d.smoothFactor())));
	}

	private static Map<Integer, Polyline> corrections(final Map<String, String> given) {
		return given.containsKey("corrections")
			? ContoursCsv.read(Path.of(given.get("corrections")))
			: Map.of();
	}

	private static int threads(final Map<String, String> given, final Settings d) {
		return OptionText.wholeNumber("threads", given.getOrDefault("threads", "" + d.threads()),
			1);
	}

	private static SortedSet<Integer> frames(final Map<String, String> given, final String key) {
		return FrameSelection.parse(key, given.getOrDefault(key, ""));
	}

	private static OptionalDouble number(final Map<String, String> given, final String key) {
		return given.containsKey(key)
			? OptionalDouble.of(OptionText.positive(key, given.get(key)))
			: OptionalDouble.empty();
	}

	private static boolean flag(final Map<String, String> given, final String key,
		final boolean byDefault) {
		return given.containsKey(key) ? OptionText.flag(key, given.get(key)) : byDefault;
	}

	private static <E extends Enum<E>> E choice(final Map<String, String> given, final String key,
		final Class<E> choices, final E byDefault) {
		return given.containsKey(key) ? OptionText.choice(key, given.get(key), choices) : byDefault;
	}

	private static Set<String> keys(final String... keys) {
		return Collections.unmodifiableSet(new LinkedHashSet<>(Arrays.asList(keys)));
	}
}
