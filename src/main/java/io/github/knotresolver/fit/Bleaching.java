package io.github.knotresolver.fit;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * How a filament's brightness fades over the movie: exponentially, as fluorophores
 * bleach. The rate is the median of the slopes between all pairs of frames (Theil and
 * Sen, doi:10.1080/01621459.1968.10480934), so that frames in which something else was
 * measured do not matter.
 *
 * @param rate of fading per frame; negative if the filament brightens; 0 if its brightness
 *          does not change noticeably
 */
public record Bleaching(double rate) {

	/** A filament that neither fades nor brightens. */
	public static final Bleaching NONE = new Bleaching(0);

	/**
	 * Learns the rate, from {@value FitTuning#BLEACHING_FRAMES} frames at most. O(frames²) for these.
	 *
	 * @param brightness of the filament in each frame, above the background; NaN or not
	 *          positive where it is not known
	 * @return the fading
	 */
	public static Bleaching learn(final double[] brightness) {
		final int[] frames = known(brightness);
		final double[] slopes = new double[frames.length * (frames.length - 1) / 2];
		int count = 0;
		for (int a = 0; a < frames.length; a++)
			for (int b = a + 1; b < frames.length; b++)
				slopes[count++] = Math.log(brightness[frames[b]] / brightness[frames[a]])
					/ (frames[b] - frames[a]);
		if (count == 0)
			return NONE;
		Arrays.sort(slopes, 0, count);
		final double rate = -slopes[count / 2];
		return Math.abs(rate) * (brightness.length - 1) < FitTuning.BLEACHED
			? NONE
			: new Bleaching(rate);
	}

	/** Frames with a known brightness; if they are many, some that are spread evenly. */
	private static int[] known(final double[] brightness) {
		final int[] all = IntStream.range(0, brightness.length).filter(t -> brightness[t] > 0)
			.toArray();
		return all.length <= FitTuning.BLEACHING_FRAMES
			? all
			: IntStream.range(0, FitTuning.BLEACHING_FRAMES).map(
				i -> all[(int) ((long) i * (all.length - 1) / (FitTuning.BLEACHING_FRAMES - 1))])
				.toArray();
	}

	/**
	 * @param frame 0-based index of the frame
	 * @return the brightness of that frame's filament relative to the first frame's
	 */
	public double factor(final int frame) {
		return Math.exp(-rate * frame);
	}
}
