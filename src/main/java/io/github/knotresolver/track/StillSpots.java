package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Spots;
import io.github.knotresolver.progress.Cancellation;

/**
 * Bright spots that stay where they are while the filament moves: beads, dirt. They are looked
 * for in what the resolved movie leaves unexplained all the time, and only what is round is
 * taken for one: a line that is left unexplained is a filament that was missed, and must go on
 * speaking against a contour. Light that lies at the fixed end is the filament's. Where lines
 * are cut off, what is left of them says too little.
 */
final class StillSpots {

	/** What is there in all but this share of the frames is there all the time. */
	private static final double QUANTILE = 0.3;

	/** So few frames do not tell what stays. */
	private static final int FEWEST = 8;

	/** So many frames, evenly spread, tell as much as all. */
	private static final int MOST = 60;

	/** Light so near (pixels) to a fixed end is the filament's. */
	private static final double NEAR_END = 8;

	/** Units that differ by less (relative) are the same. */
	private static final double SAME = 1e-6;

	private StillSpots() {
	}

	/**
	 * Takes still spots off the frames. O(pixels of all frames).
	 *
	 * @param frames as they came, background 0
	 * @param pools what was found in them
	 * @param chains the chosen curves
	 * @return the frames without them; empty if there are none
	 */
	static Optional<List<FrameView>> without(final List<FrameView> frames, final FitPools pools,
		final List<Optional<Chain>> chains) {
		final LineModel model = pools.course().estimate().model();
		final int[] known = IntStream.range(0, chains.size())
			.filter(t -> chains.get(t).isPresent()).toArray();
		if (known.length < FEWEST || model.kind() != LineModel.Kind.ADDITIVE
			|| pools.light().get(0).isClipped())
			return Optional.empty();
		final List<double[]> left = new ArrayList<>();
		final int stride = 1 + (known.length - 1) / MOST;
		for (int i = 0; i < known.length; i += stride) {
			Cancellation.check();
			left.add(Spots.residual(pools.light().get(known[i]), model,
				chains.get(known[i]).orElseThrow()));
		}
		final NormalizedFrame first = pools.light().get(0);
		final Spots spots = Spots.in(
			new NormalizedFrame(first.width(), first.height(), lasting(left)), model.sigma(),
			IntStream.range(0, frames.size()).mapToObj(pools.course().anchor()::at).toList(),
			NEAR_END);
		if (spots.isEmpty())
			return Optional.empty();
		final List<FrameView> without = new ArrayList<>();
		for (int t = 0; t < frames.size(); t++) {
			final double strand = unit(frames.get(t).light(), pools.light().get(t));
			if (!(strand > 0))
				return Optional.empty();
			without.add(
				frames.get(t).withLight(spots.takenOff(frames.get(t).light(), strand)));
		}
		return Optional.of(without);
	}

	/** What is 1 in a frame's other units; NaN if it was changed otherwise, too. */
	private static double unit(final NormalizedFrame frame, final NormalizedFrame other) {
		final double[] in = frame.pixels(), out = other.pixels();
		int top = 0;
		for (int i = 0; i < out.length; i++)
			if (out[i] > out[top])
				top = i;
		final double unit = in[top] / out[top];
		for (int i = 0; i < in.length; i++)
			if (Math.abs(in[i] - unit * out[i]) > SAME * Math.abs(in[top]))
				return Double.NaN;
		return unit;
	}

	private static double[] lasting(final List<double[]> left) {
		final double[] lasting = new double[left.get(0).length], values = new double[left.size()];
		for (int i = 0; i < lasting.length; i++) {
			for (int k = 0; k < values.length; k++)
				values[k] = left.get(k)[i];
			Arrays.sort(values);
			lasting[i] = values[(int) (QUANTILE * (values.length - 1))];
		}
		return lasting;
	}
}
