package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.Dilation;
import io.github.knotresolver.track.FrameView;

/**
 * Finds frames without light: a closed shutter, a flash that fills the picture. No line
 * is seen in them, and where the frames around them have their line, little of its light
 * is left. A frame whose line is only too faint to be seen has its light still.
 */
final class BlankFrames {

	private final List<FrameView> frames;

	/** @param frames in order of time */
	BlankFrames(final List<FrameView> frames) {
		this.frames = frames;
	}

	/** @return the frames that are not blank; all if none shows a line */
	List<FrameView> lit() {
		final List<FrameView> lit = new ArrayList<>();
		for (int t = 0; t < frames.size(); t++)
			if (!isEmpty(t) || !isBlank(t))
				lit.add(frames.get(t));
		return lit;
	}

	private boolean isEmpty(final int t) {
		return frames.get(t).graph().segments().isEmpty();
	}

	private boolean isBlank(final int t) {
		final int near = nearest(t);
		if (near < 0)
			return false;
		final FrameView other = frames.get(near);
		final boolean[] band = Dilation.square(Pixels.bits(other.mask()), other.light().width(),
			SessionTuning.BLANK_MOTION);
		return light(frames.get(t), band) < SessionTuning.NO_LIGHT * light(other, band);
	}

	/** @return the nearest frame in time that shows a line, the earlier of two; -1 if there is none */
	private int nearest(final int t) {
		for (int d = 1; d < frames.size(); d++)
			for (final int other : new int[]{t - d, t + d})
				if (other >= 0 && other < frames.size() && !isEmpty(other))
					return other;
		return -1;
	}

	private static double light(final FrameView frame, final boolean[] band) {
		final double[] pixels = frame.light().pixels();
		double sum = 0;
		for (int at = 0; at < band.length; at++)
			if (band[at])
				sum += pixels[at];
		return sum;
	}
}
