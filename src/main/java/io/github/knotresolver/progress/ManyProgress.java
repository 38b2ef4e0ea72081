package io.github.knotresolver.progress;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * How far many pieces of work are, some of them at the same time, as one line: how many are done, and
 * the stage of each that runs. Safe to use from several threads.
 */
public final class ManyProgress {

	private final Progress whole;
	private final int count;
	private final String things;
	private final Map<Part, String> stages = new LinkedHashMap<>();
	private int done;

	/**
	 * @param whole told of all of them; may cancel them
	 * @param count how many there are
	 * @param things what they are, such as "movies"
	 */
	public ManyProgress(final Progress whole, final int count, final String things) {
		this.whole = whole;
		this.count = count;
		this.things = things;
	}

	/**
	 * @param name of a piece that begins
	 * @return listens to it, until it is closed
	 */
	public Part part(final String name) {
		return new Part(name);
	}

	private void stage(final Part part, final String stage) {
		synchronized (this) {
			stages.put(part, stage);
		}
		tell();
	}

	private void ended(final Part part) {
		synchronized (this) {
			stages.remove(part);
			done++;
		}
		tell();
	}

	private void tell() {
		final String line;
		final double fraction;
		synchronized (this) {
			line = done + " of " + count + " " + things + " done"
				+ (stages.isEmpty()
					? ""
					: stages.values().stream().collect(Collectors.joining("; ", " (", ")")));
			fraction = (double) done / count;
		}
		whole.report(line, fraction);
	}

	/** A piece of the work. */
	public final class Part implements Progress, AutoCloseable {

		private final String name;

		private Part(final String name) {
			this.name = name;
		}

		@Override
		public void report(final String stage, final double fraction) {
			stage(this, String.format(Locale.ROOT, "%s: %s %.0f %%", name, stage, 100 * fraction));
		}

		@Override
		public boolean isCancelled() {
			return whole.isCancelled();
		}

		/** It has ended, one way or another. */
		@Override
		public void close() {
			ended(this);
		}
	}
}
