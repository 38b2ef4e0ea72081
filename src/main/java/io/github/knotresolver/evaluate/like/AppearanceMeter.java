package io.github.knotresolver.evaluate.like;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

import org.apache.commons.math3.stat.descriptive.rank.Median;
import org.apache.commons.math3.util.ResizableDoubleArray;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** Measures the picture of a filament whose contours are known. */
final class AppearanceMeter {

	/** Frames that are looked at, spread over the movie. */
	private static final int FRAMES = 12;

	/** Pixels farther from the filament than this are background. */
	static final double FAR = 12;

	private static final int PIECES = 8;
	private static final double DIMMEST = 0.3, BRIGHTEST = 2;

	/** Crossings and a single strand differ by half this, if strands add up. */
	private static final double BRIGHTER = 1.35;

	/** A top is flat that falls less than this, relative to a Gaussian. */
	private static final double FLAT = 0.65;

	private final Movie movie;
	private final GreyRange range;
	private final List<FrameSample> samples = new ArrayList<>();

	private AppearanceMeter(final Movie movie) {
		this.movie = movie;
		range = GreyRange.of(movie);
	}

	/**
	 * @param movie the movie
	 * @param contours one entry a frame, in pixels
	 * @param progress may cancel
	 * @return what the movie looks like
	 * @throws UserException if no bright line lies along the contours
	 */
	static Appearance of(final Movie movie, final List<Optional<Polyline>> contours,
		final Progress progress) {
		final AppearanceMeter meter = new AppearanceMeter(movie);
		final int[] present = IntStream.range(0, contours.size())
			.filter(t -> contours.get(t).isPresent() && contours.get(t).get().length() > 0)
			.toArray();
		final int count = Math.min(FRAMES, present.length);
		for (int i = 0; i < count; i++) {
			progress.checkCancelled();
			final int frame = present[(int) ((long) i * present.length / count)];
			meter.samples.add(new FrameSample(movie.frame(frame), contours.get(frame).orElseThrow(),
				meter.range, FAR));
		}
		return meter.measure(progress);
	}

	private Appearance measure(final Progress progress) {
		final double background = median(s -> s.background());
		final double noise = median(s -> s.noise());
		final double[] medians = across();
		if (!(medians[0] > 0))
			throw new UserException("Along the contours '" + movie.name()
				+ "' is not brighter than elsewhere; name the movie that the result was made from.");
		final double width = width(medians);
		final boolean saturating = range.clipped() || isSaturating(medians, width);
		final LineProfile profile = LineProfile.fit(medians,
			saturating ? medians[0] : Double.POSITIVE_INFINITY, width / 2.355, progress);
		final double onLine = range.clipped() ? noise : onLine(profile);
		return new Appearance(background, noise, Double.isNaN(onLine) ? noise : onLine, medians[0],
			width, saturating && !range.clipped(), profile, along(profile, medians[0]), range);
	}

	private double median(final ToDoubleFunction<FrameSample> figure) {
		return new Median().evaluate(samples.stream().mapToDouble(figure).toArray());
	}

	/** Median brightness by distance. */
	private double[] across() {
		final ResizableDoubleArray[] bins = new ResizableDoubleArray[(int) (FAR / LineProfile.BIN)];
		Arrays.setAll(bins, i -> new ResizableDoubleArray());
		for (final FrameSample sample : samples)
			sample.forEachBeside((distance, arc, above) -> bins[(int) (distance / LineProfile.BIN)]
				.addElement(above));
		return Arrays.stream(bins).mapToDouble(b -> new Median().evaluate(b.getElements()))
			.toArray();
	}

	private static double width(final double[] medians) {
		int i = 1;
		while (i < medians.length - 1 && !(medians[i] < medians[0] / 2))
			i++;
		final double before = medians[i - 1] - medians[0] / 2;
		final double step = Math.max(1e-9, medians[i - 1] - medians[i]);
		return 2 * LineProfile.BIN * (i - 0.5 + Math.min(1, Math.max(0, before / step)));
	}

	/** By the crossings, or if there are none by the shape of the top. */
	private boolean isSaturating(final double[] medians, final double width) {
		final ResizableDoubleArray crossings = new ResizableDoubleArray();
		for (final FrameSample sample : samples)
			for (final Point crossing : sample.crossings())
				crossings.addElement(sample.above(crossing) / medians[0]);
		if (crossings.getNumElements() >= 3)
			return new Median().evaluate(crossings.getElements()) < BRIGHTER;
		final int quarter = Math.max(1, (int) Math.rint(width / 4 / LineProfile.BIN - 0.5));
		final double at = (quarter + 0.5) * LineProfile.BIN / width;
		final double gaussian = 1 - Math.exp(-4 * Math.log(2) * at * at);
		return 1 - medians[quarter] / medians[0] < FLAT * gaussian;
	}

	private double[] along(final LineProfile profile, final double peak) {
		final ResizableDoubleArray[] pieces = new ResizableDoubleArray[PIECES];
		Arrays.setAll(pieces, i -> new ResizableDoubleArray());
		final double top = range.clipped() ? 0.9 * peak : 2 * peak;
		for (final FrameSample sample : samples)
			sample.forEachBeside((distance, arc, above) -> {
				final double expected = profile.at(distance);
				if (expected > 0.25 * peak && expected < top)
					pieces[Math.min(PIECES - 1, (int) (arc * PIECES))]
						.addElement(above / Math.min(peak, expected));
			});
		final double[] along = Arrays.stream(pieces)
			.mapToDouble(p -> p.getNumElements() == 0 ? 1 : new Median().evaluate(p.getElements()))
			.toArray();
		final double middle = new Median().evaluate(along);
		return Arrays.stream(along).map(b -> Math.max(DIMMEST, Math.min(BRIGHTEST, b / middle)))
			.toArray();
	}

	private double onLine(final LineProfile profile) {
		final ResizableDoubleArray differences = new ResizableDoubleArray();
		for (final FrameSample sample : samples)
			sample.addNoiseOnLine(profile, differences);
		return differences.getNumElements() < 30
			? Double.NaN
			: RobustStatistics.MAD_TO_SD * new Median()
				.evaluate(Arrays.stream(differences.getElements()).map(Math::abs).toArray());
	}
}
