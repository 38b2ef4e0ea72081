package io.github.knotresolver.ui;

import java.lang.ref.WeakReference;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;

import ij.ImageListener;
import ij.ImagePlus;
import io.github.knotresolver.model.Tracks;

/**
 * A result that was made in this ImageJ and is still in memory, for {@code Review Result...} and
 * {@code Correct Frame...}. Only the last one is kept, and only as long as its image is open.
 *
 * @param tracks the result
 * @param session what it was made by
 * @param texts the options that were given, by key
 * @param folder where it was written; empty if nowhere
 */
public record LiveResult(Tracks tracks, KeptSession session, Map<String, String> texts,
	Optional<Path> folder) {

	private static WeakReference<ImagePlus> lastImage = new WeakReference<>(null);
	private static LiveResult last;
	private static ImageListener listener;

	/**
	 * Keeps a result, in place of the one before.
	 *
	 * @param image the image that was resolved, shown in a window
	 * @param result its result
	 */
	public static synchronized void keep(final ImagePlus image, final LiveResult result) {
		lastImage = new WeakReference<>(image);
		last = result;
		if (listener == null) {
			listener = new Forgetting();
			ImagePlus.addImageListener(listener);
		}
	}

	/**
	 * @param image an image; may be null
	 * @return its result; empty if there is none, or not any more
	 */
	public static synchronized Optional<LiveResult> of(final ImagePlus image) {
		return image != null && image == lastImage.get()
			? Optional.ofNullable(last)
			: Optional.empty();
	}

	private static synchronized void forget(final ImagePlus image) {
		if (image == lastImage.get())
			last = null;
	}

	/** Of an image that was closed, the result goes. */
	private static final class Forgetting implements ImageListener {

		@Override
		public void imageOpened(final ImagePlus image) {
			// Of no interest.
		}

		@Override
		public void imageClosed(final ImagePlus image) {
			forget(image);
		}

		@Override
		public void imageUpdated(final ImagePlus image) {
			// Of no interest.
		}
	}
}
