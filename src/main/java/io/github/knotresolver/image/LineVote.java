package io.github.knotresolver.image;

import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * Whether a movie's lines are bright or dark, and about how wide: at eight scales and for
 * both signs, the light of what is long and falls off on both sides is added up, and the
 * most wins. Lindeberg 1998, doi:10.1023/A:1008097225773, chooses scales likewise.
 */
public final class LineVote {

	private static final int[] BINNINGS = {1, 2, 4, 8};
	private static final double[] SIGMAS = {1, Math.sqrt(2)};
	private static final int SCALES = BINNINGS.length * SIGMAS.length;

	private final double[][] votes;

	private LineVote(final double[][] votes) {
		this.votes = votes;
	}

	/**
	 * @param frames a few frames of the movie without hot pixels, row by row
	 * @param width of a row in pixels
	 * @param workers threads
	 * @param progress asked whether to stop
	 * @return the vote: for each sign and scale the median over the frames
	 */
	public static LineVote of(final List<float[]> frames, final int width, final Workers workers,
		final Progress progress) {
		final List<double[][]> each = workers.map(frames.size(), t -> {
			progress.checkCancelled();
			return votes(frames.get(t), width);
		});
		final double[][] votes = new double[2][SCALES];
		for (int sign = 0; sign < 2; sign++)
			for (int k = 0; k < SCALES; k++) {
				final int a = sign, b = k;
				votes[sign][k] = RobustStatistics
					.median(each.stream().mapToDouble(v -> v[a][b]).toArray());
			}
		return new LineVote(votes);
	}

	/** @return the sign of most light; bright if there is none */
	public Polarity polarity() {
		return largest(votes[1]) > largest(votes[0]) ? Polarity.DARK : Polarity.BRIGHT;
	}

	/**
	 * @param polarity bright or dark
	 * @return whether the other sign has so much light that the choice may be wrong
	 */
	public boolean isDoubtful(final Polarity polarity) {
		return largest(votes[polarity == Polarity.DARK ? 0 : 1]) > ImageTuning.VOTE_DOUBT
			* largest(votes[polarity == Polarity.DARK ? 1 : 0]);
	}

	/** @return whether nothing in any frame looks like a line */
	public boolean isEmpty() {
		return largest(votes[0]) == 0 && largest(votes[1]) == 0;
	}

	/**
	 * @param polarity bright or dark
	 * @return standard deviation of the filter that sees most light, in pixels
	 */
	public double sigma(final Polarity polarity) {
		final double[] of = votes[polarity == Polarity.DARK ? 1 : 0];
		int best = 0;
		for (int k = 1; k < SCALES; k++)
			if (of[k] > of[best])
				best = k;
		return SIGMAS[best % SIGMAS.length] * BINNINGS[best / SIGMAS.length];
	}

	private static double largest(final double[] values) {
		return Arrays.stream(values).max().getAsDouble();
	}

	private static double[][] votes(final float[] frame, final int width) {
		final double[][] votes = new double[2][SCALES];
		final double range = range(frame);
		for (int k = 0; k < SCALES; k++) {
			final int binning = BINNINGS[k / SIGMAS.length];
			if (Math.min(width, frame.length / width) / binning < ImageTuning.SMALLEST_PICTURE)
				continue;
			final float[] coarse = Binning.mean(frame, width, binning);
			final double sigma = SIGMAS[k % SIGMAS.length];
			final Hessian hessian = Hessian.of(coarse, width / binning, sigma);
			final float[] low = low(hessian, range);
			for (int sign = 0; sign < 2; sign++)
				votes[sign][k] = light(hessian.signed(1 - 2 * sign), sigma, low);
		}
		return votes;
	}

	private static double range(final float[] frame) {
		float smallest = Float.POSITIVE_INFINITY, largest = Float.NEGATIVE_INFINITY;
		for (final float v : frame) {
			smallest = Math.min(smallest, v);
			largest = Math.max(largest, v);
		}
		return largest - smallest;
	}

	private static float[] low(final Hessian hessian, final double range) {
		final RidgeNoise noise = new RidgeNoise(hessian.width(), hessian.height());
		for (int y = 0; y < hessian.height(); y += RidgeNoise.STRIDE) {
			noise.add(y, hessian.xx(), y * hessian.width());
			noise.add(y, hessian.yy(), y * hessian.width());
		}
		final float[] low = noise.field();
		for (int at = 0; at < low.length; at++)
			low[at] = (float) Math.max(ImageTuning.VOTE_NOISE * low[at],
				ImageTuning.VOTE_RANGE * range);
		return low;
	}

	/**
	 * Squares of the strength of what is long and falls off on both sides, times sigma to the 3rd:
	 * per length of a line that is largest where the filter fits. Binning by b divides strengths
	 * by b² and lengths by b, and sigma by b, so nothing else is needed.
	 */
	private static double light(final Hessian hessian, final double sigma, final float[] low) {
		final RidgeStrength ridges = RidgeStrength.principal(hessian);
		final RidgeSides sides = new RidgeSides(hessian, ridges, sigma * Math.sqrt(2), low);
		final boolean[] crest = new boolean[low.length];
		for (int at = 0; at < crest.length; at++)
			crest[at] = sides.isCrest(at) && !sides.isEdge(at)
				&& sides.balance(at) > ImageTuning.VOTE_BALANCE;
		double sum = 0;
		for (final int at : longParts(crest, hessian.width(), ImageTuning.VOTE_LENGTH * sigma)) {
			final double strength = ridges.strength(at) * Math.pow(sigma, 1.5);
			sum += strength * strength;
		}
		return sum;
	}

	/**
	 * The 8-connected parts of thin lines that have many pixels.
	 *
	 * @param bits row by row; emptied
	 * @param width of a row
	 * @param least number of pixels of a part
	 * @return the places of all pixels of parts that are large enough
	 */
	private static int[] longParts(final boolean[] bits, final int width, final double least) {
		final int[] places = new int[bits.length];
		int kept = 0;
		for (int start = 0; start < bits.length; start++)
			if (bits[start]) {
				final int end = fill(bits, width, start, places, kept);
				if (end - kept >= least)
					kept = end;
			}
		return Arrays.copyOf(places, kept);
	}

	private static int fill(final boolean[] bits, final int width, final int start,
		final int[] places, final int from) {
		final int height = bits.length / width;
		int count = from;
		bits[start] = false;
		places[count++] = start;
		for (int i = from; i < count; i++) {
			final int x = places[i] % width, y = places[i] / width;
			for (int v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); v++)
				for (int u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); u++)
					if (bits[v * width + u]) {
						bits[v * width + u] = false;
						places[count++] = v * width + u;
					}
		}
		return count;
	}
}
