package io.github.knotresolver.ui.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.LongSupplier;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;

/**
 * A run as a person watches it: the stage, the frame, how much of the whole is done, and the time
 * left. It hears of the work, asks it to stop, and hands on what it hears in words. Safe to use from
 * several threads.
 */
public final class RunModel implements Progress {

	/**
	 * Stages in the order of the work with their usual share of a run's time, from one filament and
	 * then from several: rough, and of use for the estimate of the time left only.
	 */
	private static final Map<String, Double> ONE = new LinkedHashMap<>(),
		SEVERAL = new LinkedHashMap<>();

	static {
		for (final Map<String, Double> stages : List.of(ONE, SEVERAL)) {
			stages.put("Looking at the movie", 0.07);
			stages.put("Finding lines", 0.05);
			stages.put("Segmenting", 0.);
			stages.put("Thinning", 0.06);
		}
		ONE.put("Looking for the fixed end", 0.01);
		ONE.put("Proposing contours", 0.04);
		ONE.put("Learning what the filament looks like", 0.25);
		ONE.put("Looking at open frames", 0.05);
		ONE.put("Fitting the proposals", 0.2);
		ONE.put("Following the filament", 0.27);
		SEVERAL.put("Learning what a filament looks like", 0.15);
		SEVERAL.put("Looking for filaments", 0.08);
		SEVERAL.put("Following the filaments", 0.59);
	}

	/** No time is told before so much time (seconds) and so much of the work are over. */
	private static final double EARLY = 2, LITTLE = 0.05;

	private static final double NANOS = 1e9, MINUTE = 60, WHOLE = 1e-6;

	private final Progress outer;
	private final LongSupplier clock;
	private final long start;
	private final SortedMap<Integer, List<Polyline>> sightings = new TreeMap<>();
	private int frames;
	private String stage = "";
	private double fraction;
	private double done;
	private boolean cancelled;

	/** @param outer told in words, and asked whether to stop */
	public RunModel(final Progress outer) {
		this(outer, System::nanoTime);
	}

	/**
	 * @param outer likewise
	 * @param clock gives nanoseconds
	 */
	RunModel(final Progress outer, final LongSupplier clock) {
		this.outer = outer;
		this.clock = clock;
		start = clock.getAsLong();
	}

	/** @param count number of frames that are resolved */
	public synchronized void frames(final int count) {
		frames = count;
	}

	@Override
	public void report(final String what, final double part) {
		final String line;
		final double whole;
		synchronized (this) {
			stage = what;
			fraction = part;
			done = Math.max(done, Math.max(done(ONE), done(SEVERAL)));
			line = line();
			whole = done;
		}
		outer.report(line, whole);
	}

	/** What is done of the whole in the present stage; 0 if that is not known. */
	private double done(final Map<String, Double> stages) {
		if (!stages.containsKey(stage))
			return 0;
		double before = 0;
		for (final Map.Entry<String, Double> s : stages.entrySet()) {
			if (s.getKey().equals(stage))
				return Math.min(1, before + s.getValue() * Math.min(1, fraction));
			before += s.getValue();
		}
		throw new IllegalStateException(stage);
	}

	@Override
	public void note(final String sentence) {
		outer.note(sentence);
	}

	@Override
	public void sighted(final int frame, final List<Polyline> contours) {
		synchronized (this) {
			sightings.put(frame, List.copyOf(contours));
		}
	}

	@Override
	public boolean isCancelled() {
		synchronized (this) {
			if (cancelled)
				return true;
		}
		return outer.isCancelled();
	}

	/** Asks the work to stop. */
	public synchronized void cancel() {
		cancelled = true;
	}

	/** @return how much of the whole is done, 0..1; never less than before */
	public synchronized double done() {
		return done;
	}

	/** @return the contours that were sighted, by their frames, in pixels */
	public synchronized SortedMap<Integer, List<Polyline>> sightings() {
		return new TreeMap<>(sightings);
	}

	/** @return the frame that the stage is at, from 1; empty where it does not go frame by frame */
	public synchronized OptionalInt frame() {
		final double frame = fraction * frames;
		return frames > 0 && frame > 0.5 && Math.abs(frame - Math.rint(frame)) < WHOLE * frames
			? OptionalInt.of((int) Math.rint(frame))
			: OptionalInt.empty();
	}

	/** @return seconds left, as far as can be told; empty at the beginning */
	public synchronized OptionalDouble secondsLeft() {
		final double over = (clock.getAsLong() - start) / NANOS;
		return over < EARLY || done < LITTLE
			? OptionalDouble.empty()
			: OptionalDouble.of(over * (1 - done) / done);
	}

	/** @return stage, frame and time left, such as {@code Finding lines: frame 41 of 120, 12 s left} */
	public synchronized String line() {
		final StringBuilder line = new StringBuilder(cancelled ? "Stopping" : stage);
		String sign = ": ";
		if (frame().isPresent()) {
			line.append(sign).append("frame ").append(frame().getAsInt()).append(" of ")
				.append(frames);
			sign = ", ";
		}
		if (secondsLeft().isPresent() && !cancelled)
			line.append(sign).append(time(secondsLeft().getAsDouble())).append(" left");
		return line.toString();
	}

	private static String time(final double seconds) {
		return seconds < MINUTE
			? String.format(Locale.ROOT, "%.0f s", Math.max(1, seconds))
			: String.format(Locale.ROOT, "%.0f min", Math.ceil(seconds / MINUTE));
	}
}
