
package io.github.knotresolver.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * All frames of a movie, measured with one smoothing. Frames without a contour,
 * or with one too short to be measured, are there but missing.
 */
public final class MovieMeasurements {

	private final String name;
	private final Calibration calibration;
	private final Smoothing smoothing;
	private final Rigidity rigidity;
	private final List<FrameMeasurement> frames;
	private final List<Quantity> spectra;
	/** Found when first asked for: tables, plots and the report ask again. */
	private final Map<Quantity, Optional<DominantFrequency>> frequencies = new ConcurrentHashMap<>();

	private MovieMeasurements(final String name, final Calibration calibration,
		final Smoothing smoothing, final Rigidity rigidity, final List<FrameMeasurement> frames,
		final List<Quantity> spectra) {
		this.name = name;
		this.calibration = calibration;
		this.smoothing = smoothing;
		this.rigidity = rigidity;
		this.frames = List.copyOf(frames);
		this.spectra = List.copyOf(spectra);
	}

	/**
	 * @param chosen quantities whose spectra are wanted
	 * @return the same measurements
	 */
	public MovieMeasurements withSpectra(final List<Quantity> chosen) {
		return new MovieMeasurements(name, calibration, smoothing, rigidity, frames, chosen);
	}

	/** @return quantities whose spectra are wanted; the tip angle if nothing was said */
	public List<Quantity> spectra() {
		return spectra;
	}

	/**
	 * Measures with the smoothing derived from all contours together and without
	 * a rigidity.
	 *
	 * @param name what the movie is called
	 * @param contoursPx one entry a frame, in pixels, fixed end first; empty where
	 *          there is no contour
	 * @param c calibration
	 * @return the measurements
	 * @throws UserException if no frame can be measured
	 */
	public static MovieMeasurements of(final String name, final List<Optional<Polyline>> contoursPx,
		final Calibration c) {
		return of(name, contoursPx, c, Optional.empty(), Rigidity.UNKNOWN, Progress.NONE);
	}

	/**
	 * Measures contours of which no more is known than their points.
	 *
	 * @param name what the movie is called
	 * @param contoursPx one entry a frame, in pixels, fixed end first; empty where
	 *          there is no contour
	 * @param c calibration
	 * @param wanted the smoothing; empty to derive it from all contours
	 * @param rigidity for the bending energy
	 * @param progress told how far it is
	 * @return the measurements
	 * @throws UserException if no frame can be measured, or the
	 *           rigidity's unit does not fit the calibration's
	 */
	public static MovieMeasurements of(final String name, final List<Optional<Polyline>> contoursPx,
		final Calibration c, final Optional<Smoothing> wanted, final Rigidity rigidity,
		final Progress progress) {
		return of(name, contoursPx, c, wanted, rigidity, 0, progress);
	}

	/**
	 * Measures. The result does not depend on the number of threads.
	 *
	 * @param name what the movie is called
	 * @param contoursPx one entry a frame, in pixels, fixed end first; empty where
	 *          there is no contour
	 * @param c calibration
	 * @param wanted the smoothing; empty to derive it from all contours
	 * @param rigidity for the bending energy
	 * @param lengthError standard error of the length that the contours were held
	 *          at, in the unit of length; 0 if they were not, or it is not known
	 * @param progress told how far it is
	 * @return the measurements
	 * @throws UserException if no frame can be measured, or the
	 *           rigidity's unit does not fit the calibration's
	 */
	public static MovieMeasurements of(final String name, final List<Optional<Polyline>> contoursPx,
		final Calibration c, final Optional<Smoothing> wanted, final Rigidity rigidity,
		final double lengthError, final Progress progress) {
		requireContours(contoursPx);
		rigidity.energyUnit(c);
		final Smoothing smoothing = wanted.orElseGet(
			() -> Smoothing.derivedFrom(contoursPx.stream().flatMap(Optional::stream).toList(), c));
		progress.report("Measuring", 0);
		final Workers workers = Workers.present();
		final List<Optional<SmoothedContour>> smoothed = workers.map(contoursPx.size(), i -> {
			progress.checkCancelled();
			return contoursPx.get(i).filter(ContourGeometry::isMeasurable)
				.map(p -> SmoothedContour.of(p, c, smoothing));
		});
		final ErrorModel errors = ErrorModel
			.learn(smoothed.stream().flatMap(Optional::stream).toList(), smoothing.order());
		final List<Optional<ContourGeometry>> geometries = workers.map(smoothed.size(), i -> {
			progress.checkCancelled();
			return smoothed.get(i)
				.map(k -> new ContourGeometry(k, smoothing, c.pixelSize(), errors));
		});
		final int[] turns = FrameMeasurement.turnsBetween(geometries);
		final List<FrameMeasurement> frames = workers.map(geometries.size(),
			i -> geometries.get(i)
				.map(g -> FrameMeasurement.of(i + 1, g, turns[i], rigidity, lengthError))
				.orElseGet(() -> FrameMeasurement.missing(i + 1)));
		progress.report("Measuring", 1);
		return new MovieMeasurements(name, c, smoothing, rigidity, frames,
			List.of(Quantity.TIP_ANGLE));
	}

	private static void requireContours(final List<Optional<Polyline>> contours) {
		if (contours.isEmpty())
			throw new UserException(
				"There are no frames to measure; give a result with at least one frame.");
		if (contours.stream().noneMatch(p -> p.filter(ContourGeometry::isMeasurable).isPresent()))
			throw new UserException("None of the " + contours.size()
				+ " frames has a contour of 3 points or more, so there is nothing to measure; resolve or correct at least one frame.");
	}

	/** @return what the movie is called */
	public String name() {
		return name;
	}

	/** @return units of length and time */
	public Calibration calibration() {
		return calibration;
	}

	/** @return the smoothing of all frames */
	public Smoothing smoothing() {
		return smoothing;
	}

	/** @return the rigidity of bending energies */
	public Rigidity rigidity() {
		return rigidity;
	}

	/** @return the frames in order; frame 1 first */
	public List<FrameMeasurement> frames() {
		return frames;
	}

	/** @return the frames that have a contour */
	public List<FrameMeasurement> measured() {
		return frames.stream().filter(FrameMeasurement::isMeasured).toList();
	}

	/** @return time of each frame in the unit of time; the first is 0 */
	public double[] times() {
		return IntStream.range(0, frames.size()).mapToDouble(i -> i * calibration.frameInterval())
			.toArray();
	}

	/**
	 * @param quantity what
	 * @return its value in each frame; NaN where it is missing
	 */
	public double[] series(final Quantity quantity) {
		return frames.stream().mapToDouble(f -> f.get(quantity).value()).toArray();
	}

	/**
	 * @param quantity what
	 * @return its standard error in each frame; NaN where it is missing
	 */
	public double[] errors(final Quantity quantity) {
		return frames.stream().mapToDouble(f -> f.get(quantity).standardError()).toArray();
	}

	/**
	 * @param quantity what
	 * @return its unit; empty for a number
	 */
	public String unit(final Quantity quantity) {
		return quantity.unit(calibration, rigidity);
	}

	/**
	 * @param quantity what
	 * @return its spectrum over time
	 */
	public Spectrum spectrum(final Quantity quantity) {
		return Spectrum.of(series(quantity), calibration.frameInterval());
	}

	/**
	 * @param quantity what
	 * @return its dominant frequency; empty if there are too few values or they do
	 *         not vary
	 */
	public Optional<DominantFrequency> dominantFrequency(final Quantity quantity) {
		return frequencies.computeIfAbsent(quantity,
			q -> DominantFrequency.of(series(q), calibration.frameInterval()));
	}

	/** @return tangent angle over arc length and time, radians */
	public Kymograph tangentAngleKymograph() {
		return Kymograph.of(this, FrameMeasurement::tangentAngle);
	}

	/** @return curvature over arc length and time, 1/unit of length */
	public Kymograph curvatureKymograph() {
		return Kymograph.of(this, f -> f.geometry().orElseThrow().curvature());
	}

	/** Median spacing of the contours' points, in the unit of length. */
	double spacing() {
		final List<Double> steps = new ArrayList<>();
		for (final FrameMeasurement f : measured()) {
			final ContourGeometry g = f.geometry().orElseThrow();
			steps.add(g.length() / (g.size() - 1));
		}
		final double[] sorted = steps.stream().mapToDouble(d -> d).sorted().toArray();
		return Arrays.stream(sorted).skip(sorted.length / 2).findFirst().orElseThrow();
	}
}
