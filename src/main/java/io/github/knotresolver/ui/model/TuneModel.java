package io.github.knotresolver.ui.model;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;

import net.imglib2.img.Img;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.OtsuThreshold;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.FrameLook;
import io.github.knotresolver.session.FramePreview;

/**
 * The segmentation of a movie while a person tunes it: the frame that is looked at, its histogram
 * with the automatic threshold, and over the whole movie how many objects each frame has and how
 * large they are, worked out from the present frame outwards. As long as nothing is changed, the masks
 * are those of the evidence, as in a run. Safe to use from several threads; listeners are told after
 * every change.
 */
public final class TuneModel implements AutoCloseable {

	/** The values that are tuned, by key, as they are by default. */
	public static final Map<String, String> AUTOMATIC;

	static {
		final Map<String, String> values = new LinkedHashMap<>();
		values.put("threshold", "otsu");
		values.put("iterations", "10");
		values.put("contraction_bias", "0.4");
		values.put("smooth_factor", "0.2");
		values.put("log_size", "0");
		values.put("log_sigma", "0");
		AUTOMATIC = Collections.unmodifiableMap(values);
	}

	private static final int BINS = 128;

	private final Movie movie;
	private final FramePreview looks, strips;
	private final LatestWork looking = new LatestWork("KnotResolver tune"),
		walking = new LatestWork("KnotResolver strip");
	private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
	private final int[] objects, areas;
	private Map<String, String> texts = AUTOMATIC;
	private int frame;
	private Optional<FrameLook> look = Optional.empty();
	private int[] histogram = new int[BINS];
	private OptionalDouble automatic = OptionalDouble.empty();
	private String line = "";
	private boolean lookGoesOn, walkGoesOn;

	/**
	 * @param movie the movie; only read
	 * @param frame that is looked at first, from 1
	 */
	public TuneModel(final Movie movie, final int frame) {
		this.movie = movie;
		this.frame = frame;
		looks = new FramePreview(movie);
		strips = new FramePreview(movie);
		objects = new int[movie.size()];
		areas = new int[movie.size()];
		begin(true);
	}

	/** @param listener told after every change */
	public void listen(final Runnable listener) {
		listeners.add(listener);
	}

	private void tell() {
		listeners.forEach(Runnable::run);
	}

	/** @return the movie */
	public Movie movie() {
		return movie;
	}

	/** @return the values, by key */
	public synchronized Map<String, String> texts() {
		return texts;
	}

	/** @return the frame that is looked at, from 1 */
	public synchronized int frame() {
		return frame;
	}

	/** @param wanted a frame, from 1; beyond the movie's ends, the nearest */
	public void goTo(final int wanted) {
		synchronized (this) {
			final int next = Math.max(1, Math.min(movie.size(), wanted));
			if (next == frame)
				return;
			frame = next;
		}
		begin(false);
	}

	/**
	 * Changes a value; one that is not allowed is said in {@link #line()}, and changes nothing.
	 *
	 * @param key of a value
	 * @param text its value
	 */
	public void set(final String key, final String text) {
		final Map<String, String> next = new LinkedHashMap<>(texts());
		if (text.equals(next.put(key, text)))
			return;
		change(next);
	}

	/** All values are automatic again. */
	public void reset() {
		change(AUTOMATIC);
	}

	private void change(final Map<String, String> next) {
		synchronized (this) {
			texts = next;
		}
		begin(true);
	}

	private Settings settings() {
		final Map<String, String> known = new LinkedHashMap<>(texts());
		// One of the two is being set; the other follows.
		known.computeIfPresent("log_size", (k, v) -> v.equals("0") ? "" : v);
		known.computeIfPresent("log_sigma", (k, v) -> v.equals("0") ? "" : v);
		return RunOptions.parse(known).settings(movie, List.of());
	}

	private void begin(final boolean anew) {
		final Settings settings;
		try {
			settings = settings();
		} catch (final UserException e) {
			synchronized (this) {
				line = e.getMessage();
			}
			tell();
			return;
		}
		final int from = frame();
		synchronized (this) {
			lookGoesOn = true;
			if (anew) {
				walkGoesOn = true;
				Arrays.fill(objects, -1);
				Arrays.fill(areas, 0);
			}
		}
		looking.start(progress -> look(settings, from, progress));
		if (anew)
			walking.start(progress -> walk(settings, from, progress));
		tell();
	}

	private void look(final Settings settings, final int at, final Progress progress) {
		final FrameLook seen = looks.look(settings, at, progress);
		final Img<FloatType> clean = looks.clean(settings, at, progress);
		final double otsu = OtsuThreshold.of(clean);
		final int[] counts = new int[BINS];
		for (final float value : Pixels.floats(clean))
			counts[Math.min(BINS - 1, Math.max(0, (int) (value * BINS)))]++;
		synchronized (this) {
			progress.checkCancelled();
			look = Optional.of(seen);
			histogram = counts;
			automatic = OptionalDouble.of(otsu);
			line = LookWords.line(seen, movie.calibration());
			lookGoesOn = false;
			notifyAll();
		}
		tell();
	}

	/** From the present frame outwards. */
	private void walk(final Settings settings, final int from, final Progress progress) {
		for (int distance = 0; distance < movie.size(); distance++)
			for (final int at : distance == 0
				? new int[]{from}
				: new int[]{from + distance, from - distance}) {
				if (at < 1 || at > movie.size())
					continue;
				final FrameLook seen = strips.look(settings, at, progress);
				synchronized (this) {
					progress.checkCancelled();
					objects[at - 1] = seen.objects();
					areas[at - 1] = seen.area();
				}
				tell();
			}
		synchronized (this) {
			progress.checkCancelled();
			walkGoesOn = false;
			notifyAll();
		}
	}

	/** @return the last look, which may be that at an earlier frame; empty before the first */
	public synchronized Optional<FrameLook> look() {
		return look;
	}

	/** @return the last look in one line of words, or what is wrong with a value */
	public synchronized String line() {
		return line;
	}

	/** @return pixels of the frame by brightness, from 0 to 1 of the stretched frame */
	public synchronized int[] histogram() {
		return histogram.clone();
	}

	/** @return the automatic threshold of the frame, 0..1 (Otsu's); empty before the first look */
	public synchronized OptionalDouble automatic() {
		return automatic;
	}

	/** @return the threshold that is set, 0..1; empty for the automatic one */
	public synchronized OptionalDouble threshold() {
		final String text = texts.get("threshold");
		return text.matches("[0-9.]+")
			? OptionalDouble.of(Double.parseDouble(text))
			: OptionalDouble.empty();
	}

	/** @return number of objects of each frame; -1 where it is not known yet */
	public synchronized int[] objects() {
		return objects.clone();
	}

	/** @return pixels of the mask of each frame */
	public synchronized int[] areas() {
		return areas.clone();
	}

	/**
	 * Waits until nothing is worked out any more.
	 *
	 * @throws InterruptedException if the thread is asked to stop
	 */
	public synchronized void atRest() throws InterruptedException {
		while (lookGoesOn || walkGoesOn)
			wait();
	}

	/** Stops the work in the background. */
	@Override
	public void close() {
		looking.close();
		walking.close();
		synchronized (this) {
			lookGoesOn = false;
			walkGoesOn = false;
			notifyAll();
		}
	}
}
