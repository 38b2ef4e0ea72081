package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.fit.Bleaching;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Cancellation;

/**
 * How bright a single strand is in each frame. Where a filament winds up, more and more of
 * it lies on itself and looks brighter; only frames in which it lies open say how its
 * brightness changes with time.
 *
 * @param light brightness above the background along the best trail of each frame; NaN
 *          where it is not known
 * @param open whether only frames count in which the filament lies open; if there are too
 *          few of them, all do
 */
record StrandLight(double[] light, boolean open) {

	/**
	 * @param frames the frames, in order of time
	 * @param sets their trails
	 */
	static StrandLight of(final List<FrameView> frames, final List<CandidateSet> sets) {
		final List<Optional<Polyline>> contours = sets.stream()
			.map(s -> s.candidates().stream().findFirst().map(StrandLight::smooth)).toList();
		final double[] lengths = contours.stream().flatMap(Optional::stream)
			.mapToDouble(Polyline::length).sorted().toArray();
		final double longest = lengths.length == 0
			? 0
			: lengths[(int) (TrackTuning.LONGEST * (lengths.length - 1))];
		final int[] open = IntStream.range(0, frames.size())
			.filter(t -> frames.get(t).graph().junctions() == 0 && contours.get(t)
				.filter(c -> c.length() >= TrackTuning.OPEN_LENGTH * longest).isPresent())
			.toArray();
		final boolean enough = open.length >= TrackTuning.LIGHT_FRAMES
			&& open[open.length - 1] - open[0] >= TrackTuning.LIGHT_SPAN * (frames.size() - 1);
		final double[] light = new double[frames.size()];
		Arrays.fill(light, Double.NaN);
		for (final int t : enough ? open : IntStream.range(0, frames.size()).toArray()) {
			Cancellation.check();
			if (contours.get(t).isPresent())
				light[t] = of(frames.get(t), contours.get(t).get());
		}
		return new StrandLight(light, enough);
	}

	private static Polyline smooth(final Candidate candidate) {
		Cancellation.check();
		return ContourBuilder.smooth(candidate);
	}

	/** The brightness of a single strand along a contour. */
	static double of(final FrameView frame, final Polyline contour) {
		final double[] light = new double[contour.size()];
		for (int i = 0; i < light.length; i++)
			light[i] = frame.light().meanAround(contour.x(i), contour.y(i));
		Arrays.sort(light);
		return light[(int) (TrackTuning.STRAND_QUANTILE * (light.length - 1))];
	}

	/** Frames as they would be if nothing had bleached, of those in which the light was seen. */
	List<FrameView> withoutBleaching(final List<FrameView> frames) {
		final int first = frames.get(0).frame();
		final double[] brightness = new double[frames.get(frames.size() - 1).frame() - first + 1];
		Arrays.fill(brightness, Double.NaN);
		for (int t = 0; t < frames.size(); t++)
			brightness[frames.get(t).frame() - first] = light[t];
		final Bleaching learned = Bleaching.learn(brightness);
		// A filament that winds up seems to brighten.
		final Bleaching bleaching = open || learned.rate() > 0 ? learned : Bleaching.NONE;
		return frames.stream().map(f -> f.scaled(bleaching.factor(f.frame() - first))).toList();
	}
}
