package io.github.knotresolver.session;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.image.Background;
import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.Dilation;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.track.FrameView;

/**
 * The frames of a movie above their background, bright lines whatever the polarity; of each
 * the part in the box around all lines. They are kept as long as they take no more than a
 * part of Java's memory; otherwise those asked for last are kept, and the others are made
 * again from the movie.
 */
final class FrameLights {

	/** The share of Java's memory for all frames. */
	private static final double SHARE = 0.25;

	/** Frames that are kept at least: those of a thread and their neighbours in time. */
	private static final int FEWEST = 4;

	private final Movie movie;
	private final Box box;
	private final int most;
	private final Map<Integer, float[]> recent = new LinkedHashMap<>(16, 0.75f, true) {

		@Override
		protected boolean removeEldestEntry(final Map.Entry<Integer, float[]> eldest) {
			return size() > most;
		}
	};

	/**
	 * @param movie the movie
	 * @param box the part of each frame, in working pixels
	 * @param memory Java's memory in bytes
	 */
	FrameLights(final Movie movie, final Box box, final long memory) {
		this.movie = movie;
		this.box = box;
		most = (int) Math.max(FEWEST, SHARE * memory / box.width() / box.height() / Float.BYTES);
	}

	/**
	 * @param frame 1-based number of a frame
	 * @param evidence its lines in the box
	 * @return its light
	 */
	NormalizedFrame of(final int frame, final FrameEvidence evidence) {
		if (movie.size() <= most)
			return NormalizedFrame.of(box.width(), box.height(), light(frame, evidence));
		return NormalizedFrame.of(box.width(), box.height(),
			(Supplier<float[]>) () -> recent(frame, evidence));
	}

	/**
	 * The frame, of which it is known above what brightness it does not say more: less its
	 * noise, since noise is cut off, too.
	 *
	 * @param view one of the frames
	 * @param recorded the movie as it was recorded
	 * @param clipping its
	 * @return the same frame with a ceiling
	 */
	FrameView withCeiling(final FrameView view, final Movie recorded, final Clipping clipping) {
		final LineAppearance a = view.evidence().orElseThrow().appearance();
		final double noise = view.light().noise();
		final float[] part = box.of(recorded.frame(view.frame() - 1), a.binning());
		final double[] light = view.light().pixels(), ceiling = new double[part.length];
		for (int i = 0; i < ceiling.length; i++)
			// Light is the pixel above its background.
			ceiling[i] = Float.isFinite(part[i])
				? clipping.ceiling() - a.polarity().sign() * part[i] + light[i] - noise
				: Double.POSITIVE_INFINITY;
		return view.withCeiling(ceiling);
	}

	private float[] recent(final int frame, final FrameEvidence evidence) {
		synchronized (recent) {
			final float[] known = recent.get(frame);
			if (known != null)
				return known;
		}
		final float[] light = light(frame, evidence);
		synchronized (recent) {
			recent.put(frame, light);
		}
		return light;
	}

	private float[] light(final int frame, final FrameEvidence evidence) {
		final LineAppearance a = evidence.appearance();
		final float[] part = box.of(movie.frame(frame - 1), a.binning());
		final boolean[] lines = Dilation.square(Pixels.bits(evidence.mask()), evidence.width(),
			(int) Math.ceil(SessionTuning.HALO * a.workingSigma()));
		final float[] background = Background.of(part, box.width(), lines);
		final float[] light = new float[part.length];
		for (int i = 0; i < light.length; i++)
			light[i] = Float.isFinite(part[i])
				? a.polarity().sign() * (part[i] - background[i])
				: 0;
		return light;
	}
}
