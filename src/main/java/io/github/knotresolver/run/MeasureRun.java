package io.github.knotresolver.run;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.io.FilamentMeasurements;
import io.github.knotresolver.io.NumberText;
import io.github.knotresolver.measure.ContourGeometry;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.measure.Rigidity;
import io.github.knotresolver.measure.Smoothing;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.CalibrationChoice;
import io.github.knotresolver.options.OptionText;
import io.github.knotresolver.options.UnitText;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * The use case of measuring contours that are there already, with its options read from text: one
 * definition for the command line and for macros. An option that is absent or blank has its default.
 */
public final class MeasureRun {

	/** Every key. */
	public static final Set<String> KEYS = Collections
		.unmodifiableSet(new LinkedHashSet<>(Arrays.asList("pixel_size", "unit", "frame_interval",
			"smoothing_window", "smoothing_order", "persistence_length", "rigidity", "spectra")));

	/** From a floppy chain measured in millimetres to a rod in nanometres. */
	private static final double SOFTEST = 1e-6, STIFFEST = 1e9;

	private final Map<String, String> given;

	private MeasureRun(final Map<String, String> given) {
		this.given = given;
	}

	/**
	 * @param texts what was typed, by key; blank for the default
	 * @return the run; values are checked by
	 *         {@link #measure(ContourInput, Progress)}
	 */
	public static MeasureRun parse(final Map<String, String> texts) {
		final Map<String, String> given = new TreeMap<>(texts);
		given.values().removeIf(text -> text == null || text.isBlank());
		return new MeasureRun(given);
	}

	/**
	 * Measures contours.
	 *
	 * @param contours the contours
	 * @param progress told how far it is
	 * @return the measurements
	 * @throws UserException if an option is not allowed, or nothing can
	 *           be measured; in one sentence
	 */
	public MovieMeasurements measure(final ContourInput contours, final Progress progress) {
		final Calibration c = calibration(contours.calibration());
		return MovieMeasurements.of(contours.name(), contours.contours(), c, smoothing(contours, c),
			stiffness(), contours.lengthErrorPx() * c.pixelSize(), progress).withSpectra(spectra());
	}

	/**
	 * Measures filaments, each by itself. Of several, those without a contour that is
	 * long enough are left out.
	 *
	 * @param filaments at least one
	 * @param progress told how far it is; may cancel
	 * @return the measurements, at least one
	 * @throws UserException if nothing can be measured, in one sentence
	 */
	public List<FilamentMeasurements> measure(final List<ContourInput> filaments,
		final Progress progress) {
		final List<FilamentMeasurements> all = new ArrayList<>();
		try (Workers workers = Workers.ofThisComputer()) {
			for (final ContourInput contours : filaments)
				if (filaments.size() == 1 || isMeasurable(contours))
					all.add(new FilamentMeasurements(contours,
						workers.during(() -> measure(contours, progress))));
		}
		if (all.isEmpty())
			throw new UserException("None of the " + filaments.size()
				+ " filaments has a contour that is long enough to be measured.");
		return all;
	}

	private static boolean isMeasurable(final ContourInput contours) {
		return contours.contours().stream()
			.anyMatch(c -> c.filter(ContourGeometry::isMeasurable).isPresent());
	}

	private List<Quantity> spectra() {
		return Arrays.stream(given.getOrDefault("spectra", Quantity.TIP_ANGLE.key()).split(","))
			.map(text -> OptionText.choice("spectra", text, Quantity.class)).distinct().toList();
	}

	private Calibration calibration(final Calibration told) {
		return new CalibrationChoice(number("pixel_size"),
			Optional.ofNullable(given.get("unit")).map(UnitText::length), number("frame_interval"))
			.over(told);
	}

	private OptionalDouble number(final String key) {
		return positive(key).map(OptionalDouble::of).orElse(OptionalDouble.empty());
	}

	private Optional<Smoothing> smoothing(final ContourInput contours, final Calibration c) {
		final double longest = contours.contours().stream().flatMap(Optional::stream)
			.mapToDouble(Polyline::length).max().orElse(0) * c.pixelSize();
		final Optional<Double> window = within("smoothing_window", c.pixelSize(),
			Math.max(2 * longest, c.pixelSize()), " " + c.unit());
		final int order = given.containsKey("smoothing_order")
			? OptionText.wholeNumber("smoothing_order", given.get("smoothing_order"))
			: Smoothing.DEFAULT_ORDER;
		if (window.isEmpty() && order == Smoothing.DEFAULT_ORDER)
			return Optional.empty();
		final double width = window.orElseGet(() -> Smoothing
			.derivedFrom(contours.contours().stream().flatMap(Optional::stream).toList(), c)
			.window());
		return Optional.of(new Smoothing(width, order));
	}

	private Rigidity stiffness() {
		final Optional<Double> length = within("persistence_length", SOFTEST, STIFFEST, "");
		final Optional<Double> rigidity = within("rigidity", SOFTEST, STIFFEST, " pN µm²");
		if (length.isPresent() && rigidity.isPresent())
			throw new UserException("Give either a persistence length or a rigidity, not both.");
		return length.map(Rigidity::ofPersistenceLength)
			.orElseGet(() -> rigidity.map(Rigidity::ofFlexural).orElse(Rigidity.UNKNOWN));
	}

	private Optional<Double> within(final String key, final double least, final double most,
		final String unit) {
		return positive(key).map(value -> {
			if (value < least || value > most)
				throw OptionText.refusal(key, "from " + NumberText.significant(least) + " to "
					+ NumberText.significant(most) + unit, given.get(key));
			return value;
		});
	}

	private Optional<Double> positive(final String key) {
		return Optional.ofNullable(given.get(key)).map(text -> OptionText.positive(key, text));
	}
}
